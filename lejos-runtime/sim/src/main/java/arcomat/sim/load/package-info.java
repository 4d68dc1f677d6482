/**
 * From a jar to classes that run on a simulated brick: reads the jar, redirects what would touch
 * the PC's clock and threads, loads everything once per brick. Knows class files, not devices.
 */
package arcomat.sim.load;
