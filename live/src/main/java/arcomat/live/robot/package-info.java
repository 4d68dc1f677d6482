/**
 * Robots whose programs are interpreted: models take their slices, and what platform components do
 * on the brick is said here once more, call by call, since the page can run no jar. A call takes
 * the time that it takes on a simulated brick without limits.
 */
package arcomat.live.robot;
