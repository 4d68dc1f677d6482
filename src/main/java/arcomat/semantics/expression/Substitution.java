package arcomat.semantics.expression;

import arcomat.model.Component;
import arcomat.model.Expression;
import arcomat.model.Variable;

import java.util.HashMap;
import java.util.List;
import java.util.Map;

/** Replaces the parameters and constants of a component by the arguments of one of its parts. */
public final class Substitution {
    private final Map<String, Expression> parameters = new HashMap<>();
    private final Map<String, Expression> constants = new HashMap<>();

    public Substitution(Component component, List<Expression> arguments) {
        for (int i = 0; i < arguments.size(); i++) {
            parameters.put(component.parameters().get(i).name(), arguments.get(i));
        }
        for (Variable constant : component.constants()) {
            constants.put(constant.name(), apply(constant.initial()));
        }
    }

    /** Replaces the constants only; what remains is over the parameters of the component. */
    public static Substitution ofConstants(Component component) {
        return new Substitution(component, List.of());
    }

    public Expression apply(Expression expression) {
        return expression.rewritten(
                leaf -> {
                    if (leaf instanceof Expression.ParameterRead read) {
                        return parameters.getOrDefault(read.parameter().name(), read);
                    }
                    if (leaf instanceof Expression.VariableRead read) {
                        return constants.getOrDefault(read.variable().name(), read);
                    }
                    return leaf;
                });
    }
}
