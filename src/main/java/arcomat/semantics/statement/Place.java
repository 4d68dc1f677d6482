package arcomat.semantics.statement;

import arcomat.model.Expression;
import arcomat.model.Variable;

import java.util.HashMap;
import java.util.HashSet;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.Set;
import java.util.function.BiPredicate;
import java.util.function.UnaryOperator;

/** A place of statements, with what is known there, while they are turned into steps. */
final class Place {
    /** By name; a variable that is not there stands in its cell, a port has not been sent on. */
    private final Map<String, HeldValue> variables;

    private final Map<String, HeldValue> ports;
    private Set<String> present;

    /** Whether something has been done that others see. */
    private boolean done;

    private Place(
            Map<String, HeldValue> variables,
            Map<String, HeldValue> ports,
            Set<String> present,
            boolean done) {
        this.variables = new HashMap<>(variables);
        this.ports = new HashMap<>(ports);
        this.present = present;
        this.done = done;
    }

    static Place beginning(Set<String> present) {
        return new Place(Map.of(), Map.of(), present, false);
    }

    Place copy(Set<String> known) {
        return new Place(variables, ports, known, done);
    }

    Set<String> present() {
        return present;
    }

    void learn(Set<String> more) {
        present = new HashSet<>(present);
        present.addAll(more);
    }

    boolean done() {
        return done;
    }

    void setDone() {
        done = true;
    }

    HeldValue variable(String name) {
        return variables.getOrDefault(name, HeldValue.CELL);
    }

    HeldValue port(String name) {
        return ports.getOrDefault(name, HeldValue.CELL);
    }

    void put(Variable variable, HeldValue meaning) {
        variables.put(variable.name(), meaning);
    }

    void putPort(String name, HeldValue meaning) {
        ports.put(name, meaning);
    }

    void forget(List<String> locals) {
        locals.forEach(variables::remove);
    }

    /** Whether something else than a variable itself is computed later from a cell. */
    boolean needs(String cell, String but) {
        BiPredicate<String, HeldValue> reads =
                (name, meaning) -> !name.equals(but) && meaning.reads(cell);
        return variables.entrySet().stream().anyMatch(e -> reads.test(e.getKey(), e.getValue()))
                || ports.values().stream().anyMatch(meaning -> meaning.reads(cell));
    }

    /** Whether anything is computed later from a cell. */
    boolean needs(String cell) {
        return needs(cell, "");
    }

    /** Reads something else where a cell is read. */
    void replace(String cell, Expression other) {
        UnaryOperator<Expression> rewrite =
                value ->
                        value.rewritten(
                                e ->
                                        e instanceof Expression.VariableRead read
                                                        && read.variable().name().equals(cell)
                                                ? other
                                                : e);
        variables.replaceAll((name, meaning) -> meaning.rewritten(rewrite));
        ports.replaceAll((name, meaning) -> meaning.rewritten(rewrite));
    }

    /**
     * What is known behind a choice.
     *
     * @param chosen whether the first branch was gone
     * @return whether it is ever asked
     */
    boolean join(Place then, Place otherwise, Variable chosen) {
        present = new HashSet<>(then.present);
        present.retainAll(otherwise.present);
        done = then.done || otherwise.done;
        boolean asked = join(variables, then.variables, otherwise.variables, chosen);
        return join(ports, then.ports, otherwise.ports, chosen) || asked;
    }

    private static boolean join(
            Map<String, HeldValue> into,
            Map<String, HeldValue> then,
            Map<String, HeldValue> otherwise,
            Variable chosen) {
        Set<String> names = new LinkedHashSet<>(then.keySet());
        names.addAll(otherwise.keySet());
        boolean asked = false;
        for (String name : names) {
            HeldValue first = then.getOrDefault(name, HeldValue.CELL);
            HeldValue second = otherwise.getOrDefault(name, HeldValue.CELL);
            boolean same = Objects.equals(first, second);
            into.put(name, same ? first : new HeldValue.Either(chosen, first, second));
            asked |= !same;
        }
        return asked;
    }
}
