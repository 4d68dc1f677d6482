package arcomat.lower;

import arcomat.model.Automaton;
import arcomat.model.Expression;
import arcomat.model.Port;
import arcomat.model.Type;
import arcomat.symbols.expressions.ItemValue;
import arcomat.symbols.expressions.Typed;
import arcomat.tree.Block;

import java.util.ArrayList;
import java.util.List;

/** Right-hand sides of items. */
record ValueLowering(ExpressionLowering expressions) {

    /** What a value on the input side asks of a port. */
    InputCondition condition(Port port, ItemValue value) {
        return new InputCondition(port, patterns(port.type(), value), value.node().span());
    }

    private List<Automaton.Pattern> patterns(Type type, ItemValue value) {
        List<Expression> values = new ArrayList<>();
        List<Automaton.Pattern> marks = new ArrayList<>();
        collect(type, value, values, marks);
        List<Automaton.Pattern> patterns = new ArrayList<>();
        if (!values.isEmpty()) {
            patterns.add(new Automaton.OneOf(values));
        }
        patterns.addAll(marks);
        return patterns;
    }

    private void collect(
            Type type, ItemValue value, List<Expression> values, List<Automaton.Pattern> marks) {
        if (value instanceof ItemValue.Alternatives alternatives) {
            alternatives.values().forEach(v -> collect(type, v, values, marks));
        } else if (value.node() instanceof Block.NoMessage) {
            marks.add(new Automaton.Absent());
        } else if (value.node() instanceof Block.AnyMessage) {
            marks.add(new Automaton.Present());
        } else {
            value.expressions().forEach(e -> values.add(expressions.lower(e, type)));
        }
    }

    /** What a value on the input side asks of a variable. */
    Expression comparison(Expression variable, ItemValue value) {
        List<Expression> equal = new ArrayList<>();
        for (Typed typed : value.expressions()) {
            equal.add(Connectives.equal(variable, expressions.lower(typed, variable.type())));
        }
        return Connectives.disjunction(equal);
    }

    /** What a value on the output side sends. */
    Automaton.Send send(Port port, ItemValue value) {
        return new Automaton.Send(port, emission(port.type(), value));
    }

    private Automaton.Emission emission(Type type, ItemValue value) {
        if (value.node() instanceof Block.NoMessage) {
            return new Automaton.Silence();
        }
        if (value.node() instanceof Block.AnyMessage) {
            return new Automaton.AnyMessage();
        }
        return new Automaton.Messages(
                value.expressions().stream().map(e -> expressions.lower(e, type)).toList());
    }
}
