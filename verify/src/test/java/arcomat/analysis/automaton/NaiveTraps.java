package arcomat.analysis.automaton;

import arcomat.analysis.automaton.exploration.SureSending;
import arcomat.analysis.reachability.Subject;
import arcomat.model.Component;
import arcomat.model.Port;
import arcomat.model.Trace;
import arcomat.model.Type;
import arcomat.model.Value;
import arcomat.semantics.automaton.Configuration;
import arcomat.semantics.automaton.Input;
import arcomat.semantics.automaton.StepRelation;
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
import java.util.stream.IntStream;

/**
 * Tries every letter wherever it comes to, with an eye on the latched ports that have a message.
 */
final class NaiveTraps {
    private record Place(Configuration configuration, Set<Integer> latched) {}

    private final Subject subject;
    private final boolean events;
    private final List<Value[]> letters = new ArrayList<>();
    private final Map<Place, Integer> depths = new HashMap<>();
    private final Map<Place, Set<Place>> before = new HashMap<>();
    private final Set<Place> mayEscape = new HashSet<>();

    private NaiveTraps(Subject subject) {
        this.subject = subject;
        this.events = subject.component().profile() == Component.Profile.EVENT_DRIVEN;
        fill(new Value[subject.component().inputs().size()], 0);
    }

    /** How many letters lead into a trap, at least; empty where there is none. */
    static Optional<Integer> lettersIntoATrap(Subject subject) {
        NaiveTraps naive = new NaiveTraps(subject);
        naive.explore();
        naive.goBack();
        return naive.depths.entrySet().stream()
                .filter(each -> !naive.mayEscape.contains(each.getKey()))
                .map(Map.Entry::getValue)
                .min(Integer::compare);
    }

    private void fill(Value[] letter, int port) {
        if (port == letter.length) {
            if (!events || eventsOf(letter) == 1) {
                letters.add(letter.clone());
            }
            return;
        }
        Port each = subject.component().inputs().get(port);
        for (Value value : values(each)) {
            letter[port] = value;
            fill(letter, port + 1);
        }
    }

    private long eventsOf(Value[] letter) {
        return IntStream.range(0, letter.length)
                .filter(i -> letter[i] != null && !subject.component().inputs().get(i).latched())
                .count();
    }

    private static List<Value> values(Port port) {
        List<Value> values = new ArrayList<>();
        if (!port.total()) {
            values.add(null);
        }
        if (port.type() instanceof Type.IntegerType integer) {
            for (long value = integer.low(); value <= integer.high(); value++) {
                values.add(new Value.IntegerValue(value));
            }
        } else {
            values.add(new Value.BooleanValue(false));
            values.add(new Value.BooleanValue(true));
        }
        return values;
    }

    private void explore() {
        Deque<Place> open = new ArrayDeque<>();
        for (Start start : subject.relation().starts()) {
            Place place = new Place(start.configuration(), Set.of());
            depths.put(place, 0);
            open.add(place);
        }
        while (!open.isEmpty()) {
            Place place = open.remove();
            for (Value[] letter : letters) {
                for (Place next : step(place, letter)) {
                    before.computeIfAbsent(next, each -> new HashSet<>()).add(place);
                    if (depths.putIfAbsent(next, depths.get(place) + 1) == null) {
                        open.add(next);
                    }
                }
            }
        }
    }

    private List<Place> step(Place place, Value[] letter) {
        Set<Integer> latched = latched(letter);
        if (!latched.containsAll(place.latched())) {
            return List.of();
        }
        Input input = Input.of(letter);
        StepRelation.Choices choices = subject.relation().choices(place.configuration(), input);
        if (!choices.faults().isEmpty()) {
            mayEscape.add(place);
        }
        List<Place> next = new ArrayList<>();
        for (Trace.Taken taken : choices.enabled()) {
            if (SureSending.sends(subject, taken.transition())) {
                mayEscape.add(place);
            }
            try {
                next.add(
                        new Place(
                                subject.relation().take(taken, place.configuration(), input).next(),
                                latched));
            } catch (Fault fault) {
                mayEscape.add(place);
            }
        }
        return next;
    }

    private Set<Integer> latched(Value[] letter) {
        Set<Integer> latched = new HashSet<>();
        for (int i = 0; i < letter.length; i++) {
            if (events && subject.component().inputs().get(i).latched() && letter[i] != null) {
                latched.add(i);
            }
        }
        return latched;
    }

    private void goBack() {
        Deque<Place> open = new ArrayDeque<>(mayEscape);
        while (!open.isEmpty()) {
            for (Place earlier : before.getOrDefault(open.remove(), Set.of())) {
                if (mayEscape.add(earlier)) {
                    open.add(earlier);
                }
            }
        }
    }
}
