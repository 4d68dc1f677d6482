/**
 * Runs models: the interpreter, choices where a model leaves something open, simulations on given
 * or random letters, stream tests, and runs written down as tests. Knows the meaning of models, but
 * neither their text nor the targets of the generator.
 */
package arcomat.simulate;
