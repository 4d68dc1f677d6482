package arcomat.analysis.automaton.trap;

import arcomat.analysis.reachability.Logic;
import arcomat.analysis.reachability.Subject;
import arcomat.analysis.reachability.SymbolicTransitions;
import arcomat.model.Expression;
import arcomat.model.Port;
import arcomat.model.Value;
import arcomat.model.Variable;
import arcomat.semantics.automaton.Configuration;
import arcomat.semantics.expression.Replacement;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;

/**
 * A configuration, reached or not.
 *
 * @param latched the ports that have had a message, of those that can be without one
 */
record Spot(Configuration configuration, Set<Port> latched) {
    Spot {
        latched = Set.copyOf(latched);
    }

    /** After the answer yes: the example's at a point of a run. */
    static Spot of(SymbolicTransitions<?> there, Subject subject) {
        var place = there.instant().place();
        Value[] letter = there.instant().letter();
        List<Port> inputs = subject.component().inputs();
        return new Spot(
                new Configuration(place.state(), place.variables().toArray(Value[]::new)),
                Set.copyOf(
                        subject.latchable().stream()
                                .filter(port -> letter[inputs.indexOf(port)] != null)
                                .toList()));
    }

    /** That a point of a run is here. */
    <T> T at(SymbolicTransitions<T> there, Subject subject, Logic<T> logic) {
        List<T> all = new ArrayList<>();
        all.add(there.instant().isIn(configuration.state()));
        List<Variable> variables = subject.automaton().variables();
        for (int i = 0; i < variables.size(); i++) {
            all.add(there.instant().is(variables.get(i), configuration.variables().get(i)));
        }
        latched.forEach(port -> all.add(there.isLatched(port)));
        return logic.and(all);
    }

    /** The value of an expression over the variables here. */
    Expression value(Expression e, Subject subject) {
        Map<String, Expression> values = new HashMap<>();
        List<Variable> variables = subject.automaton().variables();
        for (int i = 0; i < variables.size(); i++) {
            Variable each = variables.get(i);
            values.put(
                    each.name(),
                    new Expression.Constant(
                            configuration.variables().get(i), each.type(), each.span()));
        }
        return Replacement.ofVariables(values).of(e);
    }

    /** Whether a condition over the variables is true here, and nothing goes wrong in it. */
    boolean satisfies(Expression condition, Subject subject) {
        return value(condition, subject) instanceof Expression.Constant constant
                && constant.value().equals(new Value.BooleanValue(true));
    }
}
