/**
 * Refinement of automata whose variables have too many values to try: for each pair of their states
 * a condition over the variables of both, which is kept by every step that they make together. In
 * the literature a coupling or gluing invariant (Back, von Wright, "Refinement Calculus", 1998;
 * Abrial, "Modeling in Event-B", 2010). One is looked for from examples, and believed only after a
 * check that knows it as text alone.
 */
package arcomat.analysis.coupling;
