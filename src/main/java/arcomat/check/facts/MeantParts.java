package arcomat.check.facts;

import arcomat.symbols.bodies.ComponentSymbol;
import arcomat.tree.Element;

import java.util.List;

/** Variables whose type is a component and no type of messages: parts without their keyword. */
public final class MeantParts {
    private MeantParts() {}

    public static List<Element.Variables> in(ComponentSymbol component) {
        return component.node().elements(Element.Variables.class).stream()
                .filter(each -> isPart(each, component))
                .toList();
    }

    /** Whether there is one, or what may be one, since its type may be in a file with errors. */
    public static boolean mayBeIn(ComponentSymbol component) {
        return component.node().elements(Element.Variables.class).stream()
                .anyMatch(each -> mayBePart(each, component));
    }

    /**
     * Whether something with this name was meant to be a part, or may have been: its type may be
     * defined in a file with errors.
     */
    public static boolean isNamed(String name, ComponentSymbol component) {
        return component.node().elements(Element.Variables.class).stream()
                .filter(each -> mayBePart(each, component))
                .flatMap(each -> each.variables().stream())
                .anyMatch(each -> each.name().text().equals(name));
    }

    private static boolean mayBePart(Element.Variables variables, ComponentSymbol component) {
        return !component.resolveType(variables.type()).isFound()
                && !component.signature().resolveComponent(variables.type().name()).isUnknown();
    }

    private static boolean isPart(Element.Variables variables, ComponentSymbol component) {
        return component.resolveType(variables.type()).isUnknown()
                && component.signature().resolveComponent(variables.type().name()).isFound();
    }
}
