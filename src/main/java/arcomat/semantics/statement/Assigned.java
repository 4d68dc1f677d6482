package arcomat.semantics.statement;

import arcomat.model.Statement;
import arcomat.model.Variable;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;

/** What statements assign, in the order of the text. */
final class Assigned implements Statement.Cases<Void> {
    private final Map<String, Variable> variables = new LinkedHashMap<>();

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

    @Override
    public Void sequence(Statement.Sequence sequence) {
        sequence.statements().forEach(each -> each.match(this));
        return null;
    }

    @Override
    public Void declare(Statement.Declare declare) {
        return null;
    }

    @Override
    public Void assign(Statement.Assign assign) {
        variables.putIfAbsent(assign.variable().name(), assign.variable());
        return null;
    }

    @Override
    public Void send(Statement.Send send) {
        return null;
    }

    @Override
    public Void choose(Statement.Choose choose) {
        choose.then().match(this);
        choose.otherwise().match(this);
        return null;
    }
}
