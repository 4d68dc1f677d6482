package arcomat.analysis.coupling;

import arcomat.analysis.search.letter.Letters;
import arcomat.model.Automaton;
import arcomat.model.Component;
import arcomat.model.Port;
import arcomat.model.Value;
import arcomat.semantics.automaton.StepRelation.Start;
import arcomat.semantics.expression.Output;
import arcomat.semantics.expression.Sent;
import arcomat.semantics.value.GivenUp;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.HashSet;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.stream.Stream;

/** Two automata that are compared, with what decides about their steps. */
public final class Coupling {
    /** More ways in which ports may be silent are not tried. */
    private static final int MOST_SILENCES = 256;

    private static final String SEPARATOR = " with ";
    private static final String LEFT = "left";
    private static final String RIGHT = "right";

    final CoupledSide left;
    final CoupledSide right;
    final List<Port> observed;
    final List<Port> inputs;
    final List<Port> memory;

    private Coupling(CoupledSide left, CoupledSide right, List<Port> observed) {
        this.left = left;
        this.right = right;
        this.observed = List.copyOf(observed);
        this.inputs = Letters.compared(left.inputs(), right.inputs());
        this.memory = Stream.concat(left.memory().stream(), right.memory().stream()).toList();
    }

    /**
     * @param arguments one per parameter of the component
     */
    public record Subject(Component component, Automaton automaton, List<Value> arguments) {
        public Subject {
            arguments = List.copyOf(arguments);
        }

        private CoupledSide side(String name) {
            return CoupledSide.of(name, component, automaton, arguments);
        }
    }

    /**
     * @param right has ports that the left one has, too, of the same types
     * @throws GivenUp where they cannot be compared like this
     */
    public static Coupling of(Subject left, Subject right) {
        List<Port> observed = right.component.outputs();
        Coupling coupling = new Coupling(left.side(LEFT), right.side(RIGHT), observed);
        for (Port port : observed) {
            if (coupling.left.output(port.name()).delay() != port.delay()) {
                throw new GivenUp(
                        "it sends with a delay, or without one, on '%s', and the other one does not"
                                .formatted(port.name()));
            }
        }
        return coupling;
    }

    String name(StatePair pair) {
        return left.state(pair.left()) + SEPARATOR + right.state(pair.right());
    }

    /** The pair of a name; both numbers are those of states. */
    Optional<StatePair> pair(String name) {
        int end = name.indexOf(SEPARATOR);
        if (end < 0) {
            return Optional.empty();
        }
        StatePair pair =
                new StatePair(
                        left.state(name.substring(0, end)),
                        right.state(name.substring(end + SEPARATOR.length())));
        return pair.left() < 0 || pair.right() < 0 ? Optional.empty() : Optional.of(pair);
    }

    /** All that may be told of variables of both sides. */
    ComparisonText comparisons() {
        return new ComparisonText(memory);
    }

    /** Values by position in {@link #memory}. */
    Value[] row(Start mine, Start theirs) {
        return Stream.concat(
                        mine.configuration().variables().stream(),
                        theirs.configuration().variables().stream())
                .toArray(Value[]::new);
    }

    static StatePair pair(Start mine, Start theirs) {
        return new StatePair(mine.configuration().state(), theirs.configuration().state());
    }

    /** Whether a comparison says that both sides have the same value where they may correspond. */
    boolean isOfCounterparts(Comparison comparison) {
        return left.memory().contains(comparison.variable())
                && comparison
                        .same()
                        .filter(counterpart(comparison.variable()).stream().toList()::contains)
                        .isPresent();
    }

    /** The variable of the same name, else the one at the same place of as many. */
    private Optional<Port> counterpart(Port variable) {
        String name = RIGHT + variable.name().substring(LEFT.length());
        Optional<Port> alike =
                right.memory().stream().filter(each -> each.name().equals(name)).findFirst();
        return alike.isPresent() || left.memory().size() != right.memory().size()
                ? alike
                : Optional.of(right.memory().get(left.memory().indexOf(variable)));
    }

    /** Steps of the right side that lead to a state of the same name before others. */
    Comparator<PossibleStep> likest(PossibleStep mine) {
        String state = left.state(mine.target());
        return Comparator.comparing(
                theirs ->
                        right.state(theirs.target()).equals(state)
                                ? theirs.name().equals(mine.name()) ? 0 : 1
                                : 2);
    }

    /** Whether all that the left side may send at its beginning is allowed by the right one. */
    boolean isAllowed(Start mine, Start theirs) {
        return observed.stream()
                .allMatch(
                        port -> {
                            Sent sent = sent(left, mine, port);
                            return sent(right, theirs, port).meet(sent).equals(Optional.of(sent));
                        });
    }

    private static Sent sent(CoupledSide side, Start start, Port port) {
        Output output = start.output();
        return output.ports().get(side.outputs().indexOf(port.name()));
    }

    /** Whether chaos of the right side allows all that comes: it allows no error. */
    boolean endsInChaos(PossibleStep theirs) {
        return theirs.target() == PossibleStep.CHAOS && !left.mayErr();
    }

    /**
     * The ports with a message, for each way in which those that somebody reads in a pair may be
     * silent.
     */
    List<Set<String>> messages(StatePair pair) {
        Set<String> read = read(pair);
        List<Set<String>> all = new ArrayList<>(List.of(new HashSet<>()));
        for (Port port : inputs) {
            if (port.total() || !read.contains(port.name())) {
                all.forEach(each -> each.add(port.name()));
            } else {
                List<Set<String>> without = all.stream().<Set<String>>map(HashSet::new).toList();
                all.forEach(each -> each.add(port.name()));
                all.addAll(without);
            }
            if (all.size() > MOST_SILENCES) {
                throw new GivenUp("too many ports may be silent");
            }
        }
        return all;
    }

    private Set<String> read(StatePair pair) {
        Set<String> read = new HashSet<>();
        Stream.concat(
                        left.expressions(pair.left()).stream(),
                        right.expressions(pair.right()).stream())
                .flatMap(each -> each.ports().stream())
                .forEach(port -> read.add(port.name()));
        return read;
    }
}
