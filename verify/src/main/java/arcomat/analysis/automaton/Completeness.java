package arcomat.analysis.automaton;

import arcomat.analysis.automaton.exploration.Knowledge;
import arcomat.analysis.automaton.exploration.Situation;
import arcomat.analysis.reachability.Subject;
import arcomat.model.Automaton.Completion;
import arcomat.model.Component;
import arcomat.model.Port;
import arcomat.model.Value;
import arcomat.semantics.value.InputAbstraction;
import arcomat.source.Diagnostic;
import arcomat.source.Severity;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;

/**
 * An input that a state does not handle, one per state; one with a message if there is any. Under
 * {@code ignore} an automaton is complete by declaration (the paper, section 3). What chaos makes
 * of silence is a question of its own, {@link VacuousOnSilence}.
 */
final class Completeness extends Analysis {
    static final String CODE = "ARC1002";

    private final Completion completion;
    private final Map<Integer, Situation> messages = new HashMap<>();
    private final Map<Integer, Situation> silence = new HashMap<>();

    Completeness(Subject subject) {
        super(subject);
        this.completion = subject.automaton().completion();
    }

    @Override
    void see(Situation situation) {
        if (completion == Completion.IGNORE || !situation.isUnhandled()) {
            return;
        }
        if (!situation.isSilent()) {
            messages.merge(situation.state(), situation, Situation::simpler);
            return;
        }
        withMessage(situation)
                .ifPresent(each -> messages.merge(each.state(), each, Situation::simpler));
        if (!VacuousOnSilence.concerns(subject)) {
            silence.merge(situation.state(), situation, Situation::simpler);
        }
    }

    /** Silence may stand for letters with a message on a port that the state does not look at. */
    private Optional<Situation> withMessage(Situation silent) {
        List<Port> inputs = subject.component().inputs();
        List<InputAbstraction.PortAbstraction> looks =
                subject.relation().abstraction(silent.visit().configuration()).looks();
        for (int port = 0; port < inputs.size(); port++) {
            if (looks.get(port) instanceof InputAbstraction.Unseen) {
                Value[] letter = silent.letter().clone();
                letter[port] = inputs.get(port).type().first();
                return Optional.of(
                        new Situation(
                                silent.visit(),
                                letter,
                                List.of(),
                                List.of(),
                                List.of(),
                                List.of()));
            }
        }
        return Optional.empty();
    }

    @Override
    List<Finding> findings(Knowledge knowledge) {
        List<Finding> findings = new ArrayList<>();
        for (int state = 0; state < subject.automaton().states().size(); state++) {
            Situation found = messages.getOrDefault(state, silence.get(state));
            if (found != null) {
                findings.add(finding(found));
            }
        }
        return findings;
    }

    private Finding finding(Situation situation) {
        String message =
                "in %s no transition handles %s: %s"
                        .formatted(
                                words(situation.visit().configuration()),
                                words(situation.letter()),
                                consequence());
        Diagnostic warning =
                Diagnostic.warning(
                        CODE, subject.automaton().places().get(situation.state()), message);
        Diagnostic diagnostic =
                completion == Completion.ERROR ? warning.withSeverity(Severity.ERROR) : warning;
        return finding(diagnostic, situation);
    }

    private String consequence() {
        boolean events = subject.component().profile() == Component.Profile.EVENT_DRIVEN;
        return switch (completion) {
            case CHAOS -> "anything may happen from then on (completion chaos)";
            case OUTPUT -> "anything may be sent, and the state stays (completion output)";
            case ERROR ->
                    "that is forbidden (completion error), but this %s can come"
                            .formatted(events ? "event" : "input");
            case IGNORE -> throw new AssertionError(completion);
        };
    }
}
