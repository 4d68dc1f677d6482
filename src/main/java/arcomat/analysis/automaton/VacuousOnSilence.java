package arcomat.analysis.automaton;

import arcomat.analysis.smt.Subject;
import arcomat.model.Automaton.Completion;
import arcomat.model.Component;
import arcomat.source.Diagnostic;

import java.util.List;
import java.util.TreeMap;
import java.util.stream.Collectors;

/**
 * A slice in which no port carries a message is an input like any other. Under chaos, an automaton
 * that says nothing about it promises nothing after the first silent slice.
 */
final class VacuousOnSilence implements Analysis {
    static final String CODE = "ARC1006";

    private final Subject subject;
    private final Story story;
    private final Witnesses<Integer> silence = new Witnesses<>();

    VacuousOnSilence(Subject subject) {
        this.subject = subject;
        this.story = new Story(subject);
    }

    /** Whether an unhandled silence ends all promises. */
    static boolean concerns(Subject subject) {
        return subject.automaton().completion() == Completion.CHAOS
                && subject.component().profile() == Component.Profile.TIME_SYNCHRONOUS;
    }

    @Override
    public void see(Situation situation) {
        if (concerns(subject) && situation.isUnhandled() && situation.isSilent()) {
            silence.add(situation.state(), situation);
        }
    }

    @Override
    public List<Finding> findings(Knowledge knowledge) {
        TreeMap<Integer, Situation> states = silence.all();
        if (states.isEmpty()) {
            return List.of();
        }
        Situation simplest =
                states.values().stream()
                        .reduce((one, two) -> two.isSimplerThan(one) ? two : one)
                        .orElseThrow();
        String names =
                states.keySet().stream().map(subject::state).collect(Collectors.joining(", "));
        Diagnostic diagnostic =
                Diagnostic.warning(
                        CODE,
                        subject.automaton().places().get(simplest.state()),
                        ("one slice without a message, and nothing is promised any more: silence is"
                                        + " not handled in %s (completion chaos)")
                                .formatted(names));
        return List.of(story.finding(diagnostic, simplest));
    }
}
