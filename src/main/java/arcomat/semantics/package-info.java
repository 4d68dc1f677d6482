/**
 * How a model steps: enabledness, completion, composition, and the interface behind which
 * interpreter and compiled code run. Pure; knows neither text nor targets.
 */
package arcomat.semantics;
