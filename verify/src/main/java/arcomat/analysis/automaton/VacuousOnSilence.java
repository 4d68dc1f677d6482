package arcomat.analysis.automaton;

import arcomat.analysis.automaton.exploration.Knowledge;
import arcomat.analysis.automaton.exploration.Situation;
import arcomat.analysis.reachability.Subject;
import arcomat.model.Automaton.Completion;
import arcomat.model.Component;
import arcomat.source.Diagnostic;

import java.util.List;
import java.util.SortedMap;
import java.util.TreeMap;
import java.util.stream.Collectors;

/**
 * A slice in which no port carries a message is an input like any other. Under chaos, an automaton
 * that says nothing about it promises nothing after the first silent slice.
 */
final class VacuousOnSilence extends Analysis {
    static final String CODE = "ARC1006";

    private final SortedMap<Integer, Situation> silence = new TreeMap<>();

    VacuousOnSilence(Subject subject) {
        super(subject);
    }

    /** Whether an unhandled silence ends all promises. */
    static boolean concerns(Subject subject) {
        return subject.automaton().completion() == Completion.CHAOS
                && subject.component().profile() == Component.Profile.TIME_SYNCHRONOUS;
    }

    @Override
    void see(Situation situation) {
        if (concerns(subject) && situation.isUnhandled() && situation.isSilent()) {
            silence.merge(situation.state(), situation, Situation::simpler);
        }
    }

    @Override
    List<Finding> findings(Knowledge knowledge) {
        if (silence.isEmpty()) {
            return List.of();
        }
        Situation simplest = silence.values().stream().reduce(Situation::simpler).orElseThrow();
        String names =
                silence.keySet().stream().map(subject::state).collect(Collectors.joining(", "));
        Diagnostic diagnostic =
                Diagnostic.warning(
                        CODE,
                        subject.automaton().places().get(simplest.state()),
                        ("one slice without a message, and nothing is promised any more: silence is"
                                        + " not handled in %s (completion chaos)")
                                .formatted(names));
        return List.of(finding(diagnostic, simplest));
    }
}
