/**
 * What a program's objects and calls take of the brick's memory: sizes as on leJOS, stacks of
 * calls, and which objects are still in use. Knows no device, no time and no class file.
 */
package arcomat.sim.memory;
