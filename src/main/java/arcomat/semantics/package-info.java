/**
 * How a model steps: when a transition is enabled ({@link arcomat.semantics.expression.Guards}),
 * what an automaton may do ({@link arcomat.semantics.automaton.StepRelation}), a component ({@link
 * arcomat.semantics.automaton.ComponentSemantics}), how parts work together ({@link
 * arcomat.semantics.network.Composition} for generators, {@link arcomat.semantics.network.Network}
 * for interpreters), which messages it tells apart ({@link
 * arcomat.semantics.value.MessageClasses}), and the interface behind which interpreter and compiled
 * code run. Pure; knows neither text nor targets.
 */
package arcomat.semantics;
