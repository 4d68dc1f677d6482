package arcomat.lower;

import arcomat.model.Automaton;
import arcomat.model.Component;
import arcomat.model.Expression;
import arcomat.model.Variable;

import java.util.ArrayList;
import java.util.HashSet;
import java.util.IdentityHashMap;
import java.util.LinkedHashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.Optional;
import java.util.Set;

/**
 * Some ways through statements that send on the same ports, as one: where they differ, values say
 * which of them is gone.
 *
 * @param path what it does; its conditions are true where one of the ways is gone
 * @param present names of the ports that carry a message there
 */
record JoinedPath(ActionPath path, Set<String> present) {
    static final JoinedPath EMPTY = new JoinedPath(ActionPath.EMPTY, Set.of());

    /** The same so far, with nothing asked and these ports known. */
    JoinedPath unasked(Set<String> known) {
        Set<String> all = new HashSet<>(present);
        all.addAll(known);
        return new JoinedPath(new ActionPath(List.of(), path.values(), path.sends()), all);
    }

    JoinedPath with(ActionPath other) {
        return new JoinedPath(other, present);
    }

    /** The same where more conditions come first. */
    JoinedPath behind(List<Expression> conditions) {
        List<Expression> all = new ArrayList<>(conditions);
        all.addAll(path.conditions());
        return with(new ActionPath(all, path.values(), path.sends()));
    }

    /** The same without what is known no more. */
    JoinedPath without(Set<Variable> forgotten) {
        Map<Variable, Expression> values = new LinkedHashMap<>(path.values());
        values.keySet().removeAll(forgotten);
        return with(new ActionPath(path.conditions(), values, path.sends()));
    }

    /**
     * Both as one; empty where they send on other ports, or need other messages.
     *
     * @param condition true where this one is gone
     * @param reads names of ports that may be silent and that an expression reads
     */
    Optional<ActionPath> join(Expression condition, JoinedPath other, Ports reads) {
        if (!path.sends().keySet().equals(other.path.sends().keySet())) {
            return Optional.empty();
        }
        Set<String> known = new HashSet<>(present);
        known.retainAll(other.present);
        Map<String, Automaton.Send> sends = new LinkedHashMap<>();
        for (Automaton.Send send : path.sends().values()) {
            String port = send.port().name();
            Automaton.Send second = Objects.requireNonNull(other.path.sends().get(port));
            Optional<Automaton.Emission> both =
                    join(condition, send.emission(), second.emission(), known, reads);
            if (both.isEmpty()) {
                return Optional.empty();
            }
            sends.put(port, new Automaton.Send(send.port(), both.get()));
        }
        Set<Variable> variables = new LinkedHashSet<>(path.values().keySet());
        variables.addAll(other.path.values().keySet());
        Map<Variable, Expression> values = new LinkedHashMap<>();
        for (Variable variable : variables) {
            Expression first = path.current(read(variable));
            Expression second = other.path.current(read(variable));
            if (!agree(first, second, known, reads)) {
                return Optional.empty();
            }
            values.put(variable, Alternative.of(condition, first, second));
        }
        return Optional.of(new ActionPath(List.of(), values, sends));
    }

    private static Expression read(Variable variable) {
        return new Expression.VariableRead(variable, variable.span());
    }

    private static Optional<Automaton.Emission> join(
            Expression condition,
            Automaton.Emission first,
            Automaton.Emission second,
            Set<String> known,
            Ports reads) {
        if (!(first instanceof Automaton.Messages some)
                || !(second instanceof Automaton.Messages others)) {
            return first.equals(second) ? Optional.of(first) : Optional.empty();
        }
        if (some.values().size() != others.values().size()) {
            return Optional.empty();
        }
        List<Expression> values = new ArrayList<>();
        for (int i = 0; i < some.values().size(); i++) {
            Expression one = some.values().get(i);
            Expression another = others.values().get(i);
            if (!agree(one, another, known, reads)) {
                return Optional.empty();
            }
            values.add(Alternative.of(condition, one, another));
        }
        return Optional.of(new Automaton.Messages(values));
    }

    /** Whether the same messages have to be there for both. */
    private static boolean agree(
            Expression first, Expression second, Set<String> known, Ports reads) {
        if (first.equals(second)) {
            return true;
        }
        Set<String> some = new HashSet<>(reads.of(first));
        Set<String> others = new HashSet<>(reads.of(second));
        some.removeAll(known);
        others.removeAll(known);
        return some.equals(others);
    }

    /** Which ports that may be silent an expression reads. */
    static final class Ports {
        private final Component.Profile profile;
        private final Map<Expression, Set<String>> known = new IdentityHashMap<>();

        Ports(Component.Profile profile) {
            this.profile = profile;
        }

        Set<String> of(Expression e) {
            Set<String> found = known.get(e);
            if (found == null) {
                found = new HashSet<>();
                if (e instanceof Expression.PortRead read && profile.mayBeSilent(read.port())) {
                    found.add(read.port().name());
                }
                for (Expression operand : e.operands()) {
                    found.addAll(of(operand));
                }
                known.put(e, found);
            }
            return found;
        }
    }
}
