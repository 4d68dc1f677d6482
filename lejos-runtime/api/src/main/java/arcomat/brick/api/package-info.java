/**
 * What the brick offers: leJOS NXJ 0.9.1 as a table of classes and members, its own {@code java.*}
 * included, and the stub classes written from it. Used when the brick's code is built and by the
 * tool alike. Knows nothing of models, of robots' programs and of the leJOS classes' bodies, which
 * nobody has here.
 */
package arcomat.brick.api;
