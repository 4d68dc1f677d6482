/**
 * Measures the product beside what a programmer would write by hand and beside libraries for the
 * same purpose. Contestants first have to agree on their outputs; only then is time taken. Nothing
 * of the product may know this.
 */
package arcomat.benchmarks;
