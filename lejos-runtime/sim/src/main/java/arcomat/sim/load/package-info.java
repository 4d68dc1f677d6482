/**
 * From a jar to classes that run on a simulated brick: reads the jar, redirects what would touch
 * the PC's clock and threads, loads everything once per brick, or lets classes that a brick has
 * left begin again for another one. Knows class files, not devices.
 */
package arcomat.sim.load;
