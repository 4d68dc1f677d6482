package arcomat.analysis.automaton;

import arcomat.model.Automaton;
import arcomat.model.Component;
import arcomat.model.Port;
import arcomat.model.Trace;
import arcomat.model.Type;
import arcomat.model.Value;
import arcomat.semantics.automaton.ComponentSemantics;
import arcomat.semantics.automaton.Configuration;
import arcomat.semantics.automaton.Input;
import arcomat.semantics.automaton.StepRelation;
import arcomat.semantics.automaton.StepRelation.Reaction;
import arcomat.semantics.automaton.StepRelation.Start;
import arcomat.semantics.expression.Fault;

import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Deque;
import java.util.HashMap;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.TreeMap;
import java.util.TreeSet;

/** Tries every letter in every configuration. Places are those of states and transitions. */
final class NaiveExploration {
    /** Two transitions that are enabled together, by their places, with the worst that happens. */
    record Overlapping(String first, String second, String kind) {}

    private final StepRelation relation;
    private final Automaton automaton;
    private final List<Input> letters = new ArrayList<>();
    private final Map<Configuration, Integer> depths = new HashMap<>();
    private final Map<Configuration, Set<Configuration>> successors = new HashMap<>();
    private final Set<Configuration> sending = new HashSet<>();

    private final Map<String, Map<String, Integer>> pairs = new TreeMap<>();
    private final Set<String> unhandled = new TreeSet<>();
    private final Set<String> vacuous = new TreeSet<>();
    private final Set<Integer> taken = new HashSet<>();
    private final Map<String, Integer> overflows = new TreeMap<>();
    private final Map<String, Integer> divisions = new TreeMap<>();

    private NaiveExploration(Component component) {
        relation = ComponentSemantics.of(component, List.of()).relations().get(0);
        automaton = relation.automaton();
        fill(component.inputs(), new Value[component.inputs().size()], 0);
    }

    static NaiveExploration of(Component component) {
        NaiveExploration naive = new NaiveExploration(component);
        naive.explore();
        return naive;
    }

    private void fill(List<Port> ports, Value[] letter, int port) {
        if (port == ports.size()) {
            letters.add(Input.of(letter.clone()));
            return;
        }
        List<Value> values = new ArrayList<>();
        if (!ports.get(port).total()) {
            values.add(null);
        }
        if (ports.get(port).type() instanceof Type.IntegerType integer) {
            for (long value = integer.low(); value <= integer.high(); value++) {
                values.add(new Value.IntegerValue(value));
            }
        } else {
            values.add(new Value.BooleanValue(false));
            values.add(new Value.BooleanValue(true));
        }
        for (Value value : values) {
            letter[port] = value;
            fill(ports, letter, port + 1);
        }
    }

    private void explore() {
        Deque<Configuration> open = new ArrayDeque<>();
        for (Start start : relation.starts()) {
            depths.put(start.configuration(), 0);
            open.add(start.configuration());
        }
        while (!open.isEmpty()) {
            Configuration configuration = open.remove();
            successors.put(configuration, new HashSet<>());
            for (Input letter : letters) {
                for (Configuration next : step(configuration, letter)) {
                    successors.get(configuration).add(next);
                    if (depths.putIfAbsent(next, depths.get(configuration) + 1) == null) {
                        open.add(next);
                    }
                }
            }
        }
    }

    private List<Configuration> step(Configuration configuration, Input letter) {
        int depth = depths.get(configuration);
        StepRelation.Choices choices = relation.choices(configuration, letter);
        List<Trace.Taken> enabled = choices.enabled();
        for (Fault fault : choices.faults()) {
            note(fault, depth);
            sending.add(configuration);
        }
        if (enabled.isEmpty() && choices.faults().isEmpty()) {
            noteUnhandled(configuration, letter);
        }
        List<Configuration> next = new ArrayList<>();
        Map<Trace.Taken, Reaction> reactions = new HashMap<>();
        for (Trace.Taken each : enabled) {
            taken.add(each.index());
            try {
                Reaction reaction = relation.take(each, configuration, letter);
                reactions.put(each, reaction);
                next.add(reaction.next());
                if (sends(each)) {
                    sending.add(configuration);
                }
            } catch (Fault fault) {
                note(fault, depth);
                sending.add(configuration);
            }
        }
        noteOverlaps(enabled, reactions, depth);
        return next;
    }

    private boolean sends(Trace.Taken each) {
        return automaton.omitted() == Automaton.Omitted.FREE
                || each.transition().sends().stream()
                        .anyMatch(send -> !(send.emission() instanceof Automaton.Silence));
    }

    private void note(Fault fault, int depth) {
        Map<String, Integer> found =
                fault.kind() == Fault.Kind.DIVISION_BY_ZERO ? divisions : overflows;
        found.merge(place(fault.taken().orElseThrow()), depth, Math::min);
    }

    private void noteUnhandled(Configuration configuration, Input letter) {
        int ports = relation.component().inputs().size();
        boolean silent = letter.equals(Input.of(new Value[ports]));
        Automaton.Completion completion = automaton.completion();
        String place = automaton.places().get(configuration.state()).startPosition().toString();
        if (silent && completion == Automaton.Completion.CHAOS) {
            vacuous.add(place);
        } else if (completion != Automaton.Completion.IGNORE) {
            unhandled.add(place);
        }
    }

    private void noteOverlaps(
            List<Trace.Taken> enabled, Map<Trace.Taken, Reaction> reactions, int depth) {
        for (int i = 0; i < enabled.size(); i++) {
            for (int j = i + 1; j < enabled.size(); j++) {
                String kind = kind(reactions.get(enabled.get(i)), reactions.get(enabled.get(j)));
                pairs.computeIfAbsent(
                                place(enabled.get(i)) + " " + place(enabled.get(j)),
                                each -> new HashMap<>())
                        .merge(kind, depth, Math::min);
            }
        }
    }

    private static String kind(Reaction one, Reaction two) {
        if (one == null || two == null || !one.output().equals(two.output())) {
            return "OBSERVABLE";
        }
        return one.next().equals(two.next()) ? "SAME" : "HIDDEN";
    }

    private static String place(Trace.Taken taken) {
        return taken.transition().span().startPosition().toString();
    }

    /** With the fewest letters to it. */
    Map<Overlapping, Integer> overlaps() {
        Map<Overlapping, Integer> worst = new HashMap<>();
        pairs.forEach(
                (pair, kinds) -> {
                    String kind =
                            List.of("OBSERVABLE", "HIDDEN", "SAME").stream()
                                    .filter(kinds::containsKey)
                                    .findFirst()
                                    .orElseThrow();
                    String[] places = pair.split(" ");
                    worst.put(new Overlapping(places[0], places[1], kind), kinds.get(kind));
                });
        return worst;
    }

    Set<String> unhandled() {
        return unhandled;
    }

    Set<String> vacuous() {
        return vacuous;
    }

    Map<String, Integer> overflows() {
        return overflows;
    }

    Map<String, Integer> divisions() {
        return divisions;
    }

    Set<String> unreached() {
        Set<String> found = new TreeSet<>();
        for (int state = 0; state < automaton.states().size(); state++) {
            int index = state;
            if (depths.keySet().stream().noneMatch(each -> each.state() == index)) {
                found.add(automaton.places().get(state).startPosition().toString());
            }
        }
        return found;
    }

    Set<String> dead() {
        Set<String> found = new TreeSet<>();
        for (int i = 0; i < automaton.transitions().size(); i++) {
            if (!taken.contains(i)) {
                found.add(automaton.transitions().get(i).span().startPosition().toString());
            }
        }
        return found;
    }

    /** The fewest letters to a state. */
    int lettersTo(int state) {
        return depths.keySet().stream()
                .filter(each -> each.state() == state)
                .mapToInt(depths::get)
                .min()
                .orElseThrow();
    }

    /** The fewest letters to a configuration from which nothing that sends is reached. */
    Optional<Integer> wayIntoATrap() {
        return depths.keySet().stream()
                .filter(each -> !maySend(each))
                .map(depths::get)
                .min(Integer::compare);
    }

    private boolean maySend(Configuration from) {
        Set<Configuration> seen = new HashSet<>(Set.of(from));
        Deque<Configuration> open = new ArrayDeque<>(seen);
        while (!open.isEmpty()) {
            Configuration each = open.remove();
            if (sending.contains(each)) {
                return true;
            }
            successors.get(each).stream().filter(seen::add).forEach(open::add);
        }
        return false;
    }
}
