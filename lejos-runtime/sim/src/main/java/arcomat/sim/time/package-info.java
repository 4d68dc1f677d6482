/**
 * Virtual time: who runs when. All program threads of all bricks and the controller share one clock
 * and pass one baton, so a run is the same every time, however the PC schedules its threads. Knows
 * nothing of bricks or devices.
 */
package arcomat.sim.time;
