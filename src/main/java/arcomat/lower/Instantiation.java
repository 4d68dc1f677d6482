package arcomat.lower;

import arcomat.model.Type;
import arcomat.symbols.bodies.ComponentSymbol;
import arcomat.symbols.bodies.InstanceSymbol;
import arcomat.symbols.names.TypeSubstitution;
import arcomat.symbols.names.TypeVariable;

import java.util.ArrayList;
import java.util.List;
import java.util.stream.Collectors;

/**
 * A component with concrete types for the type parameters that it sees: its own, and those of the
 * components around it.
 */
record Instantiation(ComponentSymbol component, TypeSubstitution arguments) {

    static Instantiation plain(ComponentSymbol component) {
        return new Instantiation(component, TypeSubstitution.NONE);
    }

    /** What an instance inside this one instantiates. */
    Instantiation of(InstanceSymbol instance) {
        ComponentSymbol part =
                instance.component()
                        .orElseThrow(() -> new IllegalStateException("unresolved: " + instance));
        TypeSubstitution given = instance.type().substitution().then(substitution());
        return new Instantiation(part, given.only(typeVariables(part)));
    }

    /** For types as written in the component and in its ancestors. */
    TypeSubstitution substitution() {
        return component.signature().inheritedArguments().then(arguments);
    }

    /** {@code Outer.Inner<Integer>}. */
    String name() {
        String packageName = component.unit().packageText();
        String qualified = component.qualifiedName();
        String name =
                packageName.isEmpty() ? qualified : qualified.substring(packageName.length() + 1);
        List<TypeVariable> variables = typeVariables(component);
        if (variables.isEmpty()) {
            return name;
        }
        return variables.stream()
                .map(arguments::apply)
                .map(TypeLowering::lower)
                .map(Type::name)
                .collect(Collectors.joining(", ", name + "<", ">"));
    }

    private static List<TypeVariable> typeVariables(ComponentSymbol component) {
        List<TypeVariable> variables = new ArrayList<>();
        component.enclosing().ifPresent(e -> variables.addAll(typeVariables(e)));
        variables.addAll(component.signature().typeParameters());
        return variables;
    }
}
