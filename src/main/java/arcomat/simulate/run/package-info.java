/**
 * The interpreter: one run of a component, with somebody who chooses where the model leaves
 * something open, and the simulations that need many.
 */
package arcomat.simulate.run;
