/**
 * Functions of angles and of decay whose last bit is the same on every machine, and in a browser as
 * well: with another bit a robot is soon in another place.
 */
package arcomat.world.arithmetic;
