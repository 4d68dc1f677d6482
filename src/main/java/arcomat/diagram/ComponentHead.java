package arcomat.diagram;

import arcomat.diagram.Graph.Line;
import arcomat.model.Component;
import arcomat.model.ExpressionText;
import arcomat.model.Parameter;

import java.util.ArrayList;
import java.util.List;
import java.util.stream.Collectors;

/** What stands below the name of a component: its parameters, and whose promises it keeps. */
final class ComponentHead {
    private ComponentHead() {}

    static List<Line> lines(Component component) {
        List<Line> lines = new ArrayList<>();
        if (!component.parameters().isEmpty()) {
            lines.add(
                    Line.small(
                            component.parameters().stream()
                                    .map(ComponentHead::text)
                                    .collect(Collectors.joining(", ", "(", ")"))));
        }
        if (!component.refines().isEmpty()) {
            lines.add(Line.small("refines " + refined(component)));
        }
        return lines;
    }

    private static String text(Parameter parameter) {
        String initial =
                parameter.initial().map(value -> " = " + ExpressionText.of(value)).orElse("");
        return parameter.type().simpleName() + " " + parameter.name() + initial;
    }

    /** By the simple name, where that is not the component's own. */
    private static String refined(Component component) {
        return component.refines().stream()
                .map(
                        name ->
                                simpleName(name).equals(simpleName(component.name()))
                                        ? name
                                        : simpleName(name))
                .collect(Collectors.joining(", "));
    }

    /** Without the package and the components around it; type arguments stay. */
    static String simpleName(String name) {
        int arguments = name.indexOf('<');
        String plain = arguments < 0 ? name : name.substring(0, arguments);
        return name.substring(plain.lastIndexOf('.') + 1);
    }
}
