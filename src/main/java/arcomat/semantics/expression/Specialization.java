package arcomat.semantics.expression;

import arcomat.model.Component;
import arcomat.model.Component.Composite;
import arcomat.model.Component.Part;
import arcomat.model.Expression;
import arcomat.model.Parameter;
import arcomat.model.Value;
import arcomat.model.Variable;

import java.util.HashMap;
import java.util.List;
import java.util.Map;

/** A decomposed component for some values of its parameters, as if these stood in its text. */
public final class Specialization {
    private final Component component;
    private final Map<String, Expression> arguments = new HashMap<>();

    private Specialization(Component component, List<Value> values) {
        this.component = component;
        for (int i = 0; i < values.size(); i++) {
            Parameter parameter = component.parameters().get(i);
            arguments.put(
                    parameter.name(),
                    new Expression.Constant(values.get(i), parameter.type(), component.span()));
        }
    }

    /**
     * The component without parameters. What is required of it and what it promises is left out:
     * that is said of all values.
     *
     * @param component a composite
     * @param arguments one per parameter
     */
    public static Component of(Component component, List<Value> arguments) {
        if (!(component.body() instanceof Composite body)) {
            throw new IllegalArgumentException(component.qualifiedName() + " has no parts");
        }
        return new Specialization(component, arguments).of(body);
    }

    private Expression of(Expression expression) {
        return expression.rewritten(
                leaf ->
                        leaf instanceof Expression.ParameterRead read
                                ? arguments.getOrDefault(read.parameter().name(), read)
                                : leaf);
    }

    private Component of(Composite body) {
        return new Component(
                component.packageName(),
                component.name(),
                component.layer(),
                component.platform(),
                component.deploy(),
                component.profile(),
                component.queueCapacity(),
                component.cycle(),
                List.of(),
                component.constants().stream().map(this::of).toList(),
                component.ports(),
                new Composite(body.parts().stream().map(this::of).toList(), body.connections()),
                List.of(),
                List.of(),
                List.of(),
                component.span());
    }

    private Variable of(Variable constant) {
        return new Variable(
                constant.name(), constant.type(), of(constant.initial()), constant.span());
    }

    private Part of(Part part) {
        return new Part(
                part.name(),
                part.component(),
                part.arguments().stream().map(this::of).toList(),
                part.span());
    }
}
