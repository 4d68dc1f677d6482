/**
 * Refinement as a formula of monadic second-order logic on strings, which the program MONA decides
 * (Ringert, Rumpe, Wortmann 2013, section 3): the data of the formula, and what a counterexample to
 * it says about the models. Asks the step relation for every step. Knows neither the formula's
 * text, which a template writes, nor how the program is run.
 */
package arcomat.analysis.mona;
