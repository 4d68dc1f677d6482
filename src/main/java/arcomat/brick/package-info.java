/**
 * Whether a robot's jar fits on the brick: laws about class files, each of which leJOS' linker or
 * machine would break on late or never tell, and an estimate of what the linked program needs.
 * Pure: bytes in, report out. Knows class files and the table of the brick's own classes, but
 * neither models nor how the jar was made, nor where the report goes.
 */
package arcomat.brick;
