package arcomat.lower;

import arcomat.model.Expression;
import arcomat.model.Statement;

import java.util.HashMap;
import java.util.Map;

/**
 * How large values and conditions become at most, in names, literals and operators, where a name
 * stands for what was assigned to it, whichever way is gone.
 */
final class Sizes implements Statement.Cases<Void> {
    /** Beyond it, it does not matter how far. */
    private static final long TOO_MUCH = 1_000_000;

    private Map<String, Long> sizes = new HashMap<>();
    private long largest;

    private Sizes() {}

    static long largest(Statement statement) {
        Sizes sizes = new Sizes();
        statement.match(sizes);
        return sizes.largest;
    }

    private long size(Expression e) {
        long size = 1;
        if (e instanceof Expression.VariableRead read) {
            size = sizes.getOrDefault(read.variable().name(), 1L);
        }
        for (Expression operand : e.operands()) {
            size = Math.min(TOO_MUCH, size + size(operand));
        }
        largest = Math.max(largest, size);
        return size;
    }

    @Override
    public Void sequence(Statement.Sequence sequence) {
        sequence.statements().forEach(each -> each.match(this));
        return null;
    }

    @Override
    public Void declare(Statement.Declare declare) {
        sizes.put(declare.local().name(), size(declare.local().initial()));
        return null;
    }

    @Override
    public Void assign(Statement.Assign assign) {
        sizes.put(assign.variable().name(), size(assign.value()));
        return null;
    }

    @Override
    public Void send(Statement.Send send) {
        send.send().emission().values().forEach(this::size);
        return null;
    }

    @Override
    public Void choose(Statement.Choose choose) {
        size(choose.condition());
        Map<String, Long> before = new HashMap<>(sizes);
        choose.then().match(this);
        Map<String, Long> then = sizes;
        sizes = before;
        choose.otherwise().match(this);
        then.forEach((name, size) -> sizes.merge(name, size, Math::max));
        return null;
    }
}
