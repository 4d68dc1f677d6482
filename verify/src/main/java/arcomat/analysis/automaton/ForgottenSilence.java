package arcomat.analysis.automaton;

import arcomat.analysis.automaton.exploration.Situation;
import arcomat.analysis.reachability.Subject;
import arcomat.model.Automaton.Completion;
import arcomat.model.Component;
import arcomat.model.Expression;
import arcomat.model.ExpressionText;
import arcomat.model.Port;
import arcomat.source.Diagnostic;

import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.stream.Collectors;

/**
 * A guard that negates a message, such as {@code !blocked}, and can never hold while there is none:
 * what reads a silent port is undefined, and so is its negation. Nothing else is missing then, and
 * no other transition answers.
 */
final class ForgottenSilence extends WitnessedAnalysis<Integer> {
    static final String CODE = "ARC1010";

    private final Map<Integer, Boolean> told = new HashMap<>();

    ForgottenSilence(Subject subject) {
        super(subject);
    }

    /** Of the ways through a transition, which have its guard together, one is told. */
    @Override
    void see(Situation situation) {
        for (int transition : situation.silenced()) {
            if (told.computeIfAbsent(transition, this::isFirstOfItsWays)) {
                witness(transition, situation);
            }
        }
    }

    private boolean isFirstOfItsWays(int transition) {
        return subject.ways(transition).stream().noneMatch(told::containsKey);
    }

    @Override
    Finding finding(Integer transition, Situation situation) {
        Expression negation =
                subject.preconditions().get(transition).negations().stream()
                        .filter(each -> !silent(each, situation).isEmpty())
                        .findFirst()
                        .orElseThrow();
        List<String> ports = silent(negation, situation);
        String text = ExpressionText.of(negation);
        String handled =
                ports.stream().map(port -> port + " == -- || ").collect(Collectors.joining());
        String message =
                "'%s' never holds while %s, and in %s no other transition fits then: %s;"
                        + " write '(%s%s)' if silence counts as well, else handle '%s == --'";
        return finding(
                Diagnostic.warning(
                        CODE,
                        negation.span(),
                        message.formatted(
                                text,
                                silence(ports),
                                subject.state(situation.state()),
                                consequence(),
                                handled,
                                text,
                                ports.get(0))),
                situation);
    }

    private List<String> silent(Expression negation, Situation situation) {
        List<Port> inputs = subject.component().inputs();
        return negation.ports().stream()
                .filter(port -> situation.letter()[inputs.indexOf(port)] == null)
                .filter(port -> port.first().isEmpty())
                .map(Port::name)
                .distinct()
                .toList();
    }

    private String silence(List<String> ports) {
        boolean one = ports.size() == 1;
        String names = String.join(" and ", ports);
        return subject.component().profile() == Component.Profile.TIME_SYNCHRONOUS
                ? names + (one ? " is silent" : " are silent")
                : names + (one ? " has" : " have") + " had no message yet";
    }

    private String consequence() {
        Completion completion = subject.automaton().completion();
        return switch (completion) {
            case CHAOS -> "anything may happen from then on (completion chaos)";
            case OUTPUT -> "anything may be sent, and the state stays (completion output)";
            case IGNORE -> "nothing happens (completion ignore)";
            case ERROR -> "that is forbidden (completion error)";
        };
    }
}
