package arcomat.analysis.automaton;

import arcomat.analysis.automaton.exploration.Exploration;
import arcomat.analysis.automaton.exploration.Knowledge;
import arcomat.analysis.automaton.exploration.Solving;
import arcomat.analysis.automaton.induction.Strengthening;
import arcomat.analysis.reachability.RunProperty;
import arcomat.analysis.reachability.RunProperty.Difference;
import arcomat.analysis.reachability.Subject;
import arcomat.analysis.search.Budget;
import arcomat.model.Automaton;
import arcomat.model.Automaton.Transition;
import arcomat.model.Component;
import arcomat.model.Port;
import arcomat.model.Value;
import arcomat.semantics.Promise;
import arcomat.semantics.automaton.ComponentSemantics;
import arcomat.semantics.expression.Fault;
import arcomat.semantics.network.Network;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.stream.IntStream;
import java.util.stream.Stream;

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
        Knowledge solved = new Solving(subject, seen -> {}, budget).after(exploration);
        Knowledge known = Strengthening.of(solved, seen -> {}, budget);
        return Stream.of(unhandled(), wrong(), together())
                .flatMap(each -> each)
                .filter(doubt -> !known.neverHappens(doubt.property()))
                .map(doubt -> doubt.after(known))
                .findFirst();
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

    private Stream<Doubt> unhandled() {
        if (automaton.completion() == Automaton.Completion.IGNORE) {
            return Stream.empty();
        }
        return IntStream.range(0, automaton.states().size())
                .boxed()
                .flatMap(state -> Stream.of(unhandled(state, false), unhandled(state, true)));
    }

    private Doubt unhandled(int state, boolean silent) {
        String what = "does not handle " + (silent ? "silence" : "each message");
        return new Doubt(
                new RunProperty.Unhandled(state, silent),
                "state '%s' %s".formatted(subject.state(state), what));
    }

    private Stream<Doubt> wrong() {
        return IntStream.range(0, automaton.transitions().size())
                .boxed()
                .flatMap(i -> Arrays.stream(Fault.Kind.values()).map(kind -> wrong(i, kind)));
    }

    private Doubt wrong(int transition, Fault.Kind kind) {
        return new Doubt(
                new RunProperty.Wrong(transition, kind),
                subject.place(transition) + " may go wrong");
    }

    /** Whether they have the same effect does not matter: one of them would be enough. */
    private Stream<Doubt> together() {
        List<Transition> all = automaton.transitions();
        return IntStream.range(0, all.size())
                .boxed()
                .flatMap(
                        i ->
                                IntStream.range(i + 1, all.size())
                                        .filter(j -> all.get(i).source() == all.get(j).source())
                                        .mapToObj(j -> together(i, j)));
    }

    private Doubt together(int first, int second) {
        return new Doubt(
                new RunProperty.Together(first, second, Difference.ANY),
                "%s and %s may be taken on the same input"
                        .formatted(subject.place(first), subject.place(second)));
    }

    /** What would make a second output possible. */
    private record Doubt(RunProperty property, String what) {
        String after(Knowledge known) {
            return known.happens(property) ? what : "it is not known whether " + what;
        }
    }
}
