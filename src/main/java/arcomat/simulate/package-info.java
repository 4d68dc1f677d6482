/**
 * Runs models: the interpreter, choices where a model leaves something open, simulations on given
 * or random letters, stream tests, and runs written down as tests. Knows the meaning of models, and
 * of the analyses which messages the readers of a port tell apart, but neither the text of models
 * nor the targets of the generator.
 */
package arcomat.simulate;
