package arcomat.analysis.automaton;

import arcomat.analysis.automaton.exploration.Knowledge;
import arcomat.analysis.automaton.exploration.Situation;
import arcomat.analysis.reachability.Subject;

import java.util.ArrayList;
import java.util.List;
import java.util.SortedMap;
import java.util.TreeMap;

/**
 * An analysis that keeps the simplest situation for each thing that may be found.
 *
 * @param <K> what is found, in the order of the findings
 */
abstract class WitnessedAnalysis<K extends Comparable<K>> extends Analysis {
    private final SortedMap<K, Situation> witnesses = new TreeMap<>();

    WitnessedAnalysis(Subject subject) {
        super(subject);
    }

    /** Of equally simple situations the first is kept. */
    final void witness(K found, Situation situation) {
        witnesses.merge(found, situation, Situation::simpler);
    }

    @Override
    final List<Finding> findings(Knowledge knowledge) {
        List<Finding> findings = new ArrayList<>();
        witnesses.forEach((found, situation) -> findings.add(finding(found, situation)));
        return findings;
    }

    abstract Finding finding(K found, Situation situation);
}
