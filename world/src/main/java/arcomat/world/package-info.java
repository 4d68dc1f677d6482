/**
 * The floor on which robots meet: lines, walls, bodies, cups, people; what moves and what sensors
 * see of it. Pure: a scene and the speeds of shafts give the next scene. Reads the text of a world
 * and says what is wrong with it. Knows nothing of bricks, programs and models: sockets and motors
 * are numbers, a program is a name. It computes as StrictMath does, by functions of its own, so
 * that a seed gives the same run on every machine, and in every browser.
 */
package arcomat.world;
