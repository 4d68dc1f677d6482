package arcomat.semantics.expression;

import arcomat.model.Component;
import arcomat.model.Component.Composite;
import arcomat.model.Component.Part;
import arcomat.model.Expression;
import arcomat.model.Value;
import arcomat.model.Variable;

import java.util.ArrayList;
import java.util.List;

/** A decomposed component for some values of its parameters, as if these stood in its text. */
public final class Specialization {
    private final Component component;
    private final Substitution substitution;

    private Specialization(Component component, List<Expression> arguments) {
        this.component = component;
        this.substitution = new Substitution(component, arguments);
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
        return new Specialization(component, constants(component, arguments)).of(body);
    }

    private static List<Expression> constants(Component component, List<Value> arguments) {
        List<Expression> constants = new ArrayList<>();
        for (int i = 0; i < arguments.size(); i++) {
            constants.add(
                    new Expression.Constant(
                            arguments.get(i),
                            component.parameters().get(i).type(),
                            component.span()));
        }
        return constants;
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
                constant.name(),
                constant.type(),
                substitution.apply(constant.initial()),
                constant.span());
    }

    private Part of(Part part) {
        return new Part(
                part.name(),
                part.component(),
                part.arguments().stream().map(substitution::apply).toList(),
                part.span());
    }
}
