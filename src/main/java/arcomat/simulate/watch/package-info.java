/** Requirements that are watched while something else runs, and what breaks them. */
package arcomat.simulate.watch;
