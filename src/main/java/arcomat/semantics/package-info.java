/**
 * How a model steps: when a transition is enabled ({@link arcomat.semantics.Guards}), what an
 * automaton may do ({@link arcomat.semantics.StepRelation}), a component ({@link
 * arcomat.semantics.Behaviour}), how parts work together ({@link arcomat.semantics.Composition} for
 * generators, {@link arcomat.semantics.Network} for interpreters), which messages it tells apart
 * ({@link arcomat.semantics.Kinds}), and the interface behind which interpreter and compiled code
 * run. Pure; knows neither text nor targets.
 */
package arcomat.semantics;
