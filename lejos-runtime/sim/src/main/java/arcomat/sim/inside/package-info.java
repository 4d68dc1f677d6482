/**
 * What calls of the PC's own classes become in a program on a simulated brick: clock, threads,
 * exit. Loaded anew for every brick, like lejos.*. Programs never name these classes; the loader
 * rewrites calls to them.
 */
package arcomat.sim.inside;
