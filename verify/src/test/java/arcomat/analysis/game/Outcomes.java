package arcomat.analysis.game;

import arcomat.analysis.SomeValues;
import arcomat.model.Component;
import arcomat.model.Letter;
import arcomat.model.Port;
import arcomat.model.Value;
import arcomat.semantics.Promise;
import arcomat.semantics.automaton.ComponentSemantics;
import arcomat.semantics.automaton.Configuration;
import arcomat.semantics.automaton.Input;
import arcomat.semantics.automaton.StepRelation;
import arcomat.semantics.automaton.StepRelation.Reaction;
import arcomat.semantics.expression.Output;
import arcomat.semantics.expression.Sent;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.HashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.TreeSet;
import java.util.stream.IntStream;

/**
 * The meaning of requirement sets, step by step and letter by letter, with all inputs and outputs
 * written out: slow, and without any code of the engine. Positions are numbered as they are met.
 */
public final class Outcomes {
    /** The position behind an error that all requirements allow. */
    public static final int END = 0;

    /** In place of a position: this does not comply. */
    public static final int BROKEN = -1;

    /**
     * What the requirements may be in, given what was observed.
     *
     * @param held which latched ports have got a message: they never lose it
     */
    private record Position(List<Set<Configuration>> sets, List<Boolean> held) {}

    private static final int MOST_ANSWERS = 200_000;

    private record Asked(int position, Input input) {}

    private final Component component;
    private final List<StepRelation> relations = new ArrayList<>();
    private final List<Output> outputs;
    private final List<Value[]> inputs;
    private final List<Position> positions = new ArrayList<>();
    private final Map<Position, Integer> numbers = new HashMap<>();
    private final Map<Asked, int[]> answers = new HashMap<>();

    public Outcomes(List<Promise> requirements) {
        component = requirements.get(0).component();
        for (Promise each : requirements) {
            relations.addAll(
                    ComponentSemantics.of(component, each.automata(), each.arguments())
                            .relations());
        }
        outputs = everyOutput();
        inputs = letters(component.inputs()).stream().filter(this::mayCome).toList();
        number(new Position(List.of(), List.of()));
    }

    private List<Output> everyOutput() {
        List<Output> all = List.of(new Output(List.of()));
        for (Port port : component.outputs()) {
            List<Output> longer = new ArrayList<>();
            for (Output output : all) {
                for (Sent sent : sent(port)) {
                    List<Sent> ports = new ArrayList<>(output.ports());
                    ports.add(sent);
                    longer.add(new Output(ports));
                }
            }
            all = longer;
        }
        return all;
    }

    private boolean isEventDriven() {
        return component.profile() == Component.Profile.EVENT_DRIVEN;
    }

    /** One event at a time; what latched ports hold is none. */
    private boolean mayCome(Value[] letter) {
        return !isEventDriven()
                || IntStream.range(0, letter.length)
                                .filter(i -> letter[i] != null)
                                .filter(i -> !component.inputs().get(i).latched())
                                .count()
                        == 1;
    }

    /** In answer to an event, up to two messages. */
    private List<Sent> sent(Port port) {
        List<Sent> sent = new ArrayList<>();
        List<Value> values = values(port);
        for (Value one : values) {
            sent.add(Sent.of(one));
            for (Value two : isEventDriven() && one != null ? values : List.<Value>of()) {
                if (two != null) {
                    sent.add(new Sent.Messages(List.of(one, two)));
                }
            }
        }
        return sent;
    }

    /** All letters, messages by position. */
    public static List<Value[]> letters(List<Port> ports) {
        List<Value[]> letters = new ArrayList<>();
        letters.add(new Value[ports.size()]);
        for (int port = 0; port < ports.size(); port++) {
            List<Value[]> longer = new ArrayList<>();
            for (Value[] letter : letters) {
                for (Value value : values(ports.get(port))) {
                    Value[] copy = letter.clone();
                    copy[port] = value;
                    longer.add(copy);
                }
            }
            letters = longer;
        }
        return letters;
    }

    private static List<Value> values(Port port) {
        List<Value> values = new ArrayList<>();
        if (!port.total() || !port.isInput() && port.delay() == 0) {
            values.add(null);
        }
        values.addAll(SomeValues.of(port.type()));
        return values;
    }

    public List<Value[]> inputs() {
        return inputs;
    }

    private int number(Position position) {
        Integer known = numbers.putIfAbsent(position, positions.size());
        if (known == null) {
            positions.add(position);
        }
        return known == null ? positions.size() - 1 : known;
    }

    /** Per output that there is where it leads before anything is read. */
    public int[] openings() {
        List<Boolean> held = held(new Value[component.inputs().size()]);
        return outputs.stream().mapToInt(output -> opening(output, held)).toArray();
    }

    private int opening(Output output, List<Boolean> held) {
        List<Set<Configuration>> sets = new ArrayList<>();
        for (StepRelation relation : relations) {
            Set<Configuration> set = new LinkedHashSet<>();
            relation.starts().stream()
                    .filter(start -> start.output().meet(output).isPresent())
                    .forEach(start -> set.add(start.configuration()));
            sets.add(set);
        }
        return numbered(sets, held);
    }

    private int numbered(List<Set<Configuration>> sets, List<Boolean> held) {
        return sets.stream().anyMatch(Set::isEmpty) ? BROKEN : number(new Position(sets, held));
    }

    private List<Boolean> held(Value[] letter) {
        return IntStream.range(0, letter.length)
                .mapToObj(i -> letter[i] != null && component.inputs().get(i).latched())
                .toList();
    }

    /** Whether latched ports keep what they have got. */
    public boolean isPossible(int position, Value[] letter) {
        List<Boolean> before = positions.get(position).held();
        List<Boolean> after = held(letter);
        return IntStream.range(0, before.size()).noneMatch(i -> before.get(i) && !after.get(i));
    }

    /** Per output that there is where it leads; behind them where an error does. */
    public int[] answers(int position, Value[] letter) {
        return answers.computeIfAbsent(
                new Asked(position, Input.of(letter)), asked -> compute(asked, held(letter)));
    }

    private int[] compute(Asked asked, List<Boolean> held) {
        int[] found = new int[outputs.size() + 1];
        Arrays.fill(found, BROKEN);
        if (asked.position == END) {
            found[outputs.size()] = END;
            return found;
        }
        List<List<Reaction>> reactions = new ArrayList<>();
        boolean ends = true;
        for (int i = 0; i < relations.size(); i++) {
            List<Reaction> own = new ArrayList<>();
            boolean mayEnd = false;
            for (Configuration each : positions.get(asked.position).sets().get(i)) {
                StepRelation.Prospect prospect = relations.get(i).prospect(each, asked.input);
                own.addAll(prospect.reactions());
                mayEnd |= !prospect.errors().isEmpty();
            }
            reactions.add(own);
            ends &= mayEnd;
        }
        for (int output = 0; output < outputs.size(); output++) {
            Output sent = outputs.get(output);
            found[output] = numbered(reactions.stream().map(r -> after(r, sent)).toList(), held);
        }
        found[outputs.size()] = ends ? END : BROKEN;
        return found;
    }

    private static Set<Configuration> after(List<Reaction> reactions, Output sent) {
        Set<Configuration> after = new LinkedHashSet<>();
        for (Reaction reaction : reactions) {
            if (reaction.output().meet(sent).isPresent()) {
                after.add(reaction.next());
            }
        }
        return after;
    }

    /** Where an answer leads; null is an error. */
    public int after(int position, Value[] letter, Output sent) {
        int[] all = answers(position, letter);
        return all[sent == null ? outputs.size() : outputs.indexOf(sent)];
    }

    /** Where a beginning leads. */
    public int opening(Output sent) {
        return openings()[outputs.indexOf(sent)];
    }

    private static int[] distinct(int[] answers) {
        return Arrays.stream(answers).filter(each -> each != BROKEN).distinct().toArray();
    }

    public Value[] letter(Letter input) {
        return component.inputs().stream()
                .map(port -> input.message(port.name()).orElse(null))
                .toArray(Value[]::new);
    }

    /** Whether some outputs comply after a word. */
    public boolean somethingComplies(List<Letter> word) {
        Set<Integer> reached = new TreeSet<>();
        Arrays.stream(distinct(openings())).forEach(reached::add);
        for (Letter letter : word) {
            Set<Integer> next = new TreeSet<>();
            for (int each : reached) {
                Arrays.stream(distinct(answers(each, letter(letter)))).forEach(next::add);
            }
            reached = next;
        }
        return !reached.isEmpty();
    }

    /** Whether the environment can make every system break a requirement with so many inputs. */
    public boolean isLost(int inputsLeft) {
        Map<List<Integer>, Boolean> known = new HashMap<>();
        return Arrays.stream(distinct(openings()))
                .allMatch(each -> isLost(each, inputsLeft, known));
    }

    private boolean isLost(int position, int left, Map<List<Integer>, Boolean> known) {
        if (left == 0 || position == END) {
            return false;
        }
        Boolean before = known.get(List.of(position, left));
        if (before == null) {
            before =
                    inputs.stream()
                            .filter(letter -> isPossible(position, letter))
                            .map(letter -> distinct(answers(position, letter)))
                            .anyMatch(
                                    next ->
                                            Arrays.stream(next)
                                                    .allMatch(n -> isLost(n, left - 1, known)));
            known.put(List.of(position, left), before);
        }
        return before;
    }

    /**
     * Whether the environment can make every system break a requirement, however long that takes.
     *
     * @param errs whether a system may err where all requirements allow it
     * @return empty where there are too many positions
     */
    public Optional<Boolean> isEverLost(boolean errs) {
        int[] first = distinct(openings());
        return lost(errs).map(lost -> Arrays.stream(first).allMatch(lost::contains));
    }

    /** All positions from which it can. */
    public Optional<Set<Integer>> lost(boolean errs) {
        openings();
        Set<Integer> lost = new TreeSet<>();
        for (int position = 1; position < positions.size(); position++) {
            if (positions.size() * inputs.size() * outputs.size() > MOST_ANSWERS) {
                return Optional.empty();
            }
            for (Value[] letter : inputs) {
                if (isPossible(position, letter)) {
                    answers(position, letter);
                }
            }
        }
        for (boolean again = true; again; ) {
            again = false;
            for (int position = 1; position < positions.size(); position++) {
                again |=
                        !lost.contains(position)
                                && falls(position, lost, errs)
                                && lost.add(position);
            }
        }
        return Optional.of(lost);
    }

    private boolean falls(int position, Set<Integer> lost, boolean errs) {
        return inputs.stream()
                .filter(letter -> isPossible(position, letter))
                .anyMatch(
                        letter ->
                                Arrays.stream(distinct(answers(position, letter)))
                                        .allMatch(
                                                next -> next == END ? !errs : lost.contains(next)));
    }
}
