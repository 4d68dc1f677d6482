package arcomat.generate.text;

import arcomat.model.Port;
import arcomat.model.Type;
import arcomat.model.Value;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.LinkedHashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.Optional;
import java.util.Set;
import java.util.function.Predicate;

/**
 * All cases that some conditions tell apart and in which none of the earlier ones holds. There may
 * be more of them than in a run: what is so in all of these is always so.
 */
final class OpenCases {
    /** Looking at more would make large automata slow to generate, for little. */
    private static final int MOST = 128;

    private static final int MOST_EARLIER = 16;

    /** What a port shows beside the messages that are asked for: another one, or none. */
    private enum Shown {
        OTHER,
        NOTHING
    }

    private final Predicate<Port> mayBeAbsent;
    private final Map<String, Set<Object>> choices = new LinkedHashMap<>();
    private final List<Map<String, Object>> cases = new ArrayList<>();

    private OpenCases(Predicate<Port> mayBeAbsent) {
        this.mayBeAbsent = mayBeAbsent;
    }

    /** None where there are too many, or where a condition may go wrong or is not understood. */
    static Optional<OpenCases> of(
            Predicate<Port> mayBeAbsent, Formula condition, List<Formula> earlier) {
        OpenCases all = new OpenCases(mayBeAbsent);
        if (earlier.size() > MOST_EARLIER
                || !all.understands(condition)
                || !earlier.stream().allMatch(all::understands)
                || all.count() > MOST) {
            return Optional.empty();
        }
        all.collect(new ArrayList<>(all.choices.keySet()), new HashMap<>(), earlier);
        return Optional.of(all);
    }

    /**
     * The conjuncts without those that follow from the others. A condition that holds in no case
     * stays as it is.
     */
    List<Formula> needed(List<Formula> conjuncts) {
        if (cases.stream().noneMatch(c -> hold(conjuncts, c))) {
            return conjuncts;
        }
        List<Formula> kept = new ArrayList<>(conjuncts);
        for (int i = conjuncts.size() - 1; i >= 0; i--) {
            Formula asked = kept.remove(i);
            if (cases.stream().anyMatch(c -> hold(kept, c) && !holds(asked, c))) {
                kept.add(i, asked);
            }
        }
        return kept;
    }

    /** Notes what a condition depends on. */
    private boolean understands(Formula f) {
        return f.match(
                new Formula.Cases<>(
                        carries -> {
                            addPresence(carries.port());
                            return true;
                        },
                        this::understands,
                        test -> {
                            choices.put(fact(test), Set.of(true, false));
                            return !test.mayFail();
                        },
                        not -> understands(not.operand()),
                        row -> row.operands().stream().allMatch(this::understands),
                        judged -> false));
    }

    private boolean understands(Formula.Is is) {
        Port port = is.port();
        boolean finite =
                port.type() instanceof Type.EnumType || port.type() instanceof Type.BooleanType;
        if (is.constant().isEmpty() || !finite) {
            return false;
        }
        addPresence(port);
        Set<Object> messages = messages(port);
        messages.add(is.constant().get());
        if (port.type() instanceof Type.EnumType type && holdsAll(messages, type)) {
            messages.remove(Shown.OTHER);
        }
        return true;
    }

    private static boolean holdsAll(Set<Object> messages, Type.EnumType type) {
        long asked = messages.stream().filter(Value.EnumValue.class::isInstance).count();
        return asked == type.constants().size();
    }

    /** An enum that is silent is another code; others still hold an old message. */
    private void addPresence(Port port) {
        if (port.type() instanceof Type.EnumType) {
            messages(port);
        } else if (mayBeAbsent.test(port)) {
            choices.put(presence(port), Set.of(true, false));
        }
    }

    private Set<Object> messages(Port port) {
        return choices.computeIfAbsent(message(port), key -> new LinkedHashSet<>(others(port)));
    }

    private Set<Object> others(Port port) {
        if (port.type() instanceof Type.BooleanType) {
            return Set.of(new Value.BooleanValue(false), new Value.BooleanValue(true));
        }
        return mayBeAbsent.test(port) ? Set.of(Shown.OTHER, Shown.NOTHING) : Set.of(Shown.OTHER);
    }

    private static String presence(Port port) {
        return "presence of " + port.name();
    }

    private static String message(Port port) {
        return "message on " + port.name();
    }

    private static String fact(Formula.Test test) {
        return "fact " + test.fact();
    }

    private int count() {
        int count = 1;
        for (Set<Object> some : choices.values()) {
            count = Math.min(MOST + 1, count * some.size());
        }
        return count;
    }

    private void collect(List<String> open, Map<String, Object> chosen, List<Formula> earlier) {
        if (open.isEmpty()) {
            if (earlier.stream().noneMatch(f -> holds(f, chosen))) {
                cases.add(Map.copyOf(chosen));
            }
            return;
        }
        String key = open.get(0);
        for (Object choice : Objects.requireNonNull(choices.get(key))) {
            chosen.put(key, choice);
            collect(open.subList(1, open.size()), chosen, earlier);
        }
    }

    private boolean hold(List<Formula> conjuncts, Map<String, Object> in) {
        return conjuncts.stream().allMatch(f -> holds(f, in));
    }

    private boolean holds(Formula f, Map<String, Object> in) {
        return f.match(
                new Formula.Cases<>(
                        carries -> isPresent(carries.port(), in) == carries.something(),
                        is -> {
                            Object shown = Objects.requireNonNull(in.get(message(is.port())));
                            return shown.equals(is.constant().orElseThrow()) == is.equal();
                        },
                        test -> Objects.requireNonNull(in.get(fact(test))).equals(test.so()),
                        not -> !holds(not.operand(), in),
                        row ->
                                row.all()
                                        ? hold(row.operands(), in)
                                        : row.operands().stream().anyMatch(o -> holds(o, in)),
                        judged -> {
                            throw new AssertionError(judged);
                        }));
    }

    private boolean isPresent(Port port, Map<String, Object> in) {
        return port.type() instanceof Type.EnumType
                ? in.get(message(port)) != Shown.NOTHING
                : !mayBeAbsent.test(port)
                        || Objects.requireNonNull(in.get(presence(port))).equals(true);
    }
}
