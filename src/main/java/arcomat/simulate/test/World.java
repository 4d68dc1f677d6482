package arcomat.simulate.test;

import arcomat.semantics.automaton.Configuration;
import arcomat.semantics.expression.Sent;

import java.util.List;

/**
 * A state of a network between two slices.
 *
 * @param configurations per instance, per automaton
 * @param registers per signal what its next slice shows; silence for a signal without a register
 */
record World(List<List<Configuration>> configurations, List<Sent> registers) {}
