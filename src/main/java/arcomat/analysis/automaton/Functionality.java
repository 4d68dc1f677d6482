package arcomat.analysis.automaton;

import arcomat.analysis.automaton.exploration.Exploration;
import arcomat.analysis.automaton.exploration.Knowledge;
import arcomat.analysis.automaton.exploration.Solving;
import arcomat.analysis.refinement.Promise;
import arcomat.analysis.search.Budget;
import arcomat.analysis.smt.RunProperty;
import arcomat.analysis.smt.RunProperty.Difference;
import arcomat.analysis.smt.Subject;
import arcomat.model.Automaton;
import arcomat.model.Automaton.Transition;
import arcomat.model.Component;
import arcomat.model.Port;
import arcomat.model.Value;
import arcomat.semantics.automaton.ComponentSemantics;
import arcomat.semantics.expression.Fault;
import arcomat.semantics.network.Network;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.Set;

/**
 * Whether a component answers each input with one output and no other: a function of streams. Said
 * only where it is certain; parts of a composition are looked at one by one, with any input.
 */
public final class Functionality {
    private final Subject subject;
    private final Automaton automaton;

    private Functionality(Subject subject) {
        this.subject = subject;
        this.automaton = subject.automaton();
    }

    /** Why it is none, or why that is not known; empty where it is one. */
    public static Optional<String> obstacle(Promise promise, Budget budget) {
        if (!promise.isComposition()) {
            return ofAtomic(
                    promise.component(), promise.automata(), promise.arguments(), "", budget);
        }
        Network network = promise.network();
        if (!network.devices().isEmpty()) {
            return Optional.of(
                    "nothing is known of the device '%s'"
                            .formatted(network.devices().get(0).path()));
        }
        return network.instances().stream()
                .map(part -> ofPart(part, budget))
                .flatMap(Optional::stream)
                .findFirst();
    }

    private static Optional<String> ofPart(Network.Instance part, Budget budget) {
        List<Automaton> automata = ((Component.Atomic) part.component().body()).automata();
        String prefix = part.path() + ": ";
        return ofAtomic(part.component(), automata, part.arguments(), prefix, budget);
    }

    private static Optional<String> ofAtomic(
            Component component,
            List<Automaton> automata,
            List<Value> arguments,
            String prefix,
            Budget budget) {
        if (automata.size() != 1) {
            return Optional.of(
                    prefix
                            + (automata.isEmpty()
                                    ? "nothing says what it does"
                                    : "it has several automata"));
        }
        Automaton automaton = automata.get(0);
        return Budget.within(
                () -> {
                    try {
                        Subject subject = Subject.of(component, automaton, arguments);
                        return new Functionality(subject).obstacle(budget).map(prefix::concat);
                    } catch (Fault fault) {
                        return Optional.of(prefix + fault.getMessage());
                    }
                },
                reason -> Optional.of(prefix + reason));
    }

    private Optional<String> obstacle(Budget budget) {
        Optional<String> written = asWritten();
        if (written.isPresent()) {
            return written;
        }
        Exploration exploration = new Exploration(subject, seen -> {}, budget);
        exploration.run();
        Knowledge known = new Solving(subject, seen -> {}, budget).after(exploration);
        return unhandled(known).or(() -> wrong(known)).or(() -> together(known));
    }

    /** What can be told without a run. */
    private Optional<String> asWritten() {
        if (automaton.initials().size() != 1) {
            return Optional.of("it has several beginnings");
        }
        Set<String> decided = ComponentSemantics.owned(subject.component(), automaton);
        return subject.component().outputs().stream()
                .map(Port::name)
                .filter(port -> !decided.contains(port) || isLeftOpen(port))
                .findFirst()
                .map("'%s' may be anything"::formatted);
    }

    private boolean isLeftOpen(String port) {
        List<List<Automaton.Send>> blocks = new ArrayList<>();
        automaton.initials().forEach(each -> blocks.add(each.sends()));
        automaton.transitions().forEach(each -> blocks.add(each.sends()));
        return blocks.stream().anyMatch(block -> isLeftOpen(port, block));
    }

    private boolean isLeftOpen(String port, List<Automaton.Send> block) {
        return block.stream()
                .filter(send -> send.port().name().equals(port))
                .findFirst()
                .map(send -> send.emission().match(messages -> false, () -> false, () -> true))
                .orElse(automaton.omitted() == Automaton.Omitted.FREE);
    }

    private Optional<String> unhandled(Knowledge known) {
        if (automaton.completion() == Automaton.Completion.IGNORE) {
            return Optional.empty();
        }
        for (int state = 0; state < automaton.states().size(); state++) {
            for (boolean silent : new boolean[] {false, true}) {
                String what = "does not handle " + (silent ? "silence" : "each message");
                Optional<String> found =
                        doubt(
                                new RunProperty.Unhandled(state, silent),
                                known,
                                "state '%s' %s".formatted(subject.state(state), what));
                if (found.isPresent()) {
                    return found;
                }
            }
        }
        return Optional.empty();
    }

    private Optional<String> wrong(Knowledge known) {
        for (int i = 0; i < automaton.transitions().size(); i++) {
            for (Fault.Kind kind : Fault.Kind.values()) {
                Optional<String> found =
                        doubt(
                                new RunProperty.Wrong(i, kind),
                                known,
                                subject.place(i) + " may go wrong");
                if (found.isPresent()) {
                    return found;
                }
            }
        }
        return Optional.empty();
    }

    /** Whether they have the same effect does not matter: one of them would be enough. */
    private Optional<String> together(Knowledge known) {
        List<Transition> all = automaton.transitions();
        for (int i = 0; i < all.size(); i++) {
            for (int j = i + 1; j < all.size(); j++) {
                if (all.get(i).source() == all.get(j).source()) {
                    Optional<String> found =
                            doubt(
                                    new RunProperty.Together(i, j, Difference.ANY),
                                    known,
                                    "%s and %s may be taken on the same input"
                                            .formatted(subject.place(i), subject.place(j)));
                    if (found.isPresent()) {
                        return found;
                    }
                }
            }
        }
        return Optional.empty();
    }

    private static Optional<String> doubt(RunProperty property, Knowledge known, String what) {
        return known.neverHappens(property)
                ? Optional.empty()
                : Optional.of(known.happens(property) ? what : "it is not known whether " + what);
    }
}
