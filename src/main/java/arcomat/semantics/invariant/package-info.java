/**
 * What invariants of components say of a run: a component beside an observer that speaks where one
 * is not true. Asks the step relation and the network for everything that happens.
 */
package arcomat.semantics.invariant;
