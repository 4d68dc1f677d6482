package arcomat.semantics.statement;

import arcomat.model.Expression;
import arcomat.model.Statement;
import arcomat.model.Variable;
import arcomat.semantics.expression.Presence;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;

/** What statements assign, and whether computing it may go wrong. */
final class Assigned implements Statement.Cases<Void> {
    private final Map<String, Variable> variables = new LinkedHashMap<>();
    private boolean mayFail;

    private Assigned() {}

    static Assigned in(Statement statement) {
        Assigned assigned = new Assigned();
        statement.match(assigned);
        return assigned;
    }

    /** Those that are there before the statements, in the order in which the text assigns them. */
    List<Variable> variables() {
        return new ArrayList<>(variables.values());
    }

    /** Whether a condition or a value may go wrong, whoever needs it. */
    boolean mayFail() {
        return mayFail;
    }

    private void look(Expression value) {
        mayFail |= Presence.mayFail(value);
    }

    @Override
    public Void sequence(Statement.Sequence sequence) {
        sequence.statements().forEach(each -> each.match(this));
        return null;
    }

    @Override
    public Void declare(Statement.Declare declare) {
        look(declare.local().initial());
        return null;
    }

    @Override
    public Void assign(Statement.Assign assign) {
        look(assign.value());
        variables.putIfAbsent(assign.variable().name(), assign.variable());
        return null;
    }

    @Override
    public Void send(Statement.Send send) {
        send.send().emission().values().forEach(this::look);
        return null;
    }

    @Override
    public Void choose(Statement.Choose choose) {
        look(choose.condition());
        choose.then().match(this);
        choose.otherwise().match(this);
        return null;
    }
}
