package arcomat.generate;

import arcomat.model.Port;
import arcomat.model.Type;
import arcomat.model.Value;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.LinkedHashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.function.Predicate;

/**
 * All cases that some conditions tell apart and in which none of the earlier ones holds. There may
 * be more of them than in a run: what is so in all of these is always so.
 */
final class Cases {
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

    private Cases(Predicate<Port> mayBeAbsent) {
        this.mayBeAbsent = mayBeAbsent;
    }

    /** None where there are too many, or where a condition may go wrong or is not understood. */
    static Optional<Cases> of(
            Predicate<Port> mayBeAbsent, Formula condition, List<Formula> earlier) {
        Cases all = new Cases(mayBeAbsent);
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
        if (f instanceof Formula.Carries carries) {
            addPresence(carries.port());
            return true;
        }
        if (f instanceof Formula.Is is) {
            return is.constant().isPresent() && understands(is.port(), is.constant().get());
        }
        if (f instanceof Formula.Test test) {
            choices.put(fact(test), Set.of(true, false));
            return !test.mayFail();
        }
        if (f instanceof Formula.Not not) {
            return understands(not.operand());
        }
        if (f instanceof Formula.And and) {
            return and.operands().stream().allMatch(this::understands);
        }
        if (f instanceof Formula.Or or) {
            return or.operands().stream().allMatch(this::understands);
        }
        return true;
    }

    private boolean understands(Port port, Value constant) {
        if (constant instanceof Value.EnumValue || constant instanceof Value.BooleanValue) {
            addPresence(port);
            Set<Object> messages = messages(port);
            messages.add(constant);
            if (port.type() instanceof Type.EnumType type && holdsAll(messages, type)) {
                messages.remove(Shown.OTHER);
            }
            return true;
        }
        return false;
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
            choices.put("presence of " + port.name(), Set.of(true, false));
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
        for (Object choice : choices.get(key)) {
            chosen.put(key, choice);
            collect(open.subList(1, open.size()), chosen, earlier);
        }
    }

    private boolean hold(List<Formula> conjuncts, Map<String, Object> in) {
        return conjuncts.stream().allMatch(f -> holds(f, in));
    }

    private boolean holds(Formula f, Map<String, Object> in) {
        if (f instanceof Formula.Truth truth) {
            return truth.value();
        }
        if (f instanceof Formula.Carries carries) {
            return isPresent(carries.port(), in) == carries.something();
        }
        if (f instanceof Formula.Is is) {
            return in.get(message(is.port())).equals(is.constant().orElseThrow()) == is.equal();
        }
        if (f instanceof Formula.Test test) {
            return in.get(fact(test)).equals(test.so());
        }
        if (f instanceof Formula.Not not) {
            return !holds(not.operand(), in);
        }
        if (f instanceof Formula.And and) {
            return hold(and.operands(), in);
        }
        return ((Formula.Or) f).operands().stream().anyMatch(operand -> holds(operand, in));
    }

    private boolean isPresent(Port port, Map<String, Object> in) {
        if (port.type() instanceof Type.EnumType) {
            return in.get(message(port)) != Shown.NOTHING;
        }
        return !mayBeAbsent.test(port) || in.get("presence of " + port.name()).equals(true);
    }
}
