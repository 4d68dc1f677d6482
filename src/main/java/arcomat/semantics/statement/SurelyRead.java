package arcomat.semantics.statement;

import arcomat.model.Automaton;
import arcomat.model.Expression;
import arcomat.model.Statement;
import arcomat.semantics.expression.Presence;

import java.util.HashMap;
import java.util.HashSet;
import java.util.Map;
import java.util.Set;

/**
 * The ports that statements read on all ways through them, by a condition or by what is kept in the
 * end. Where one of them is silent no way is open, so that may be asked first of all.
 */
final class SurelyRead implements Statement.Cases<Void> {
    private static final String PORT = "port ";

    private final Automaton automaton;
    private final Presence presence;
    private Map<String, Set<String>> values = new HashMap<>();
    private final Set<String> failing = new HashSet<>();
    private Set<String> needed = new HashSet<>();
    private boolean decidesWrongly;

    private SurelyRead(Automaton automaton, Presence presence) {
        this.automaton = automaton;
        this.presence = presence;
    }

    /** Names of ports; none where a condition may go wrong, since that comes first. */
    static Set<String> of(Statement statement, Automaton automaton, Presence presence) {
        SurelyRead reading = new SurelyRead(automaton, presence);
        statement.match(reading);
        if (reading.decidesWrongly) {
            return Set.of();
        }
        Set<String> all = new HashSet<>(reading.needed);
        reading.values.forEach(
                (name, read) -> {
                    if (name.startsWith(PORT) || reading.isKept(name)) {
                        all.addAll(read);
                    }
                });
        return all;
    }

    private boolean isKept(String name) {
        return automaton.variables().stream().anyMatch(each -> each.name().equals(name));
    }

    private boolean mayFail(Expression value) {
        return Presence.mayFail(value)
                || value.contains(
                        e ->
                                e instanceof Expression.VariableRead read
                                        && failing.contains(read.variable().name()));
    }

    private void put(String name, Expression value) {
        values.put(name, read(value));
        if (mayFail(value)) {
            failing.add(name);
        }
    }

    private Set<String> read(Expression value) {
        Set<String> read = presence.open(value, Set.of());
        value.visit(
                e -> {
                    if (e instanceof Expression.VariableRead variable) {
                        read.addAll(values.getOrDefault(variable.variable().name(), Set.of()));
                    }
                });
        return read;
    }

    @Override
    public Void sequence(Statement.Sequence sequence) {
        sequence.statements().forEach(each -> each.match(this));
        return null;
    }

    @Override
    public Void declare(Statement.Declare declare) {
        put(declare.local().name(), declare.local().initial());
        return null;
    }

    @Override
    public Void assign(Statement.Assign assign) {
        put(assign.variable().name(), assign.value());
        return null;
    }

    @Override
    public Void send(Statement.Send send) {
        Set<String> read = new HashSet<>();
        send.send().emission().values().forEach(value -> read.addAll(read(value)));
        values.put(PORT + send.send().port().name(), read);
        return null;
    }

    @Override
    public Void choose(Statement.Choose choose) {
        decidesWrongly |= mayFail(choose.condition());
        if (presence.isStrict(choose.condition())) {
            needed.addAll(presence.open(choose.condition(), Set.of()));
        }
        Map<String, Set<String>> valuesBefore = copy(values);
        Set<String> neededBefore = new HashSet<>(needed);
        choose.then().match(this);
        Map<String, Set<String>> thenValues = values;
        Set<String> thenNeeded = needed;
        values = valuesBefore;
        needed = neededBefore;
        choose.otherwise().match(this);
        needed.retainAll(thenNeeded);
        values.keySet().retainAll(thenValues.keySet());
        values.forEach((name, read) -> read.retainAll(thenValues.getOrDefault(name, Set.of())));
        return null;
    }

    private static Map<String, Set<String>> copy(Map<String, Set<String>> values) {
        Map<String, Set<String>> copy = new HashMap<>();
        values.forEach((name, read) -> copy.put(name, new HashSet<>(read)));
        return copy;
    }
}
