package arcomat.generate.views;

import arcomat.generate.language.FileReferences;
import arcomat.generate.language.Places;
import arcomat.generate.language.TypeName;
import arcomat.generate.plan.Program;
import arcomat.generate.text.FileContext;
import arcomat.generate.text.MentionedTypes;
import arcomat.generate.view.HeadView;
import arcomat.generate.view.HeadView.FieldView;
import arcomat.generate.view.HeadView.PortView;
import arcomat.generate.view.HeadView.TypeView;
import arcomat.model.Component;
import arcomat.model.Parameter;
import arcomat.model.Port;
import arcomat.model.Type;

import java.util.List;
import java.util.Set;
import java.util.stream.Collectors;

/** What all views of components have in common. */
public final class Heads {
    private Heads() {}

    /** The head of a component that is generated as part of a program. */
    public static HeadView of(Component component, Program program) {
        return of(program.context(component), program.draws(component));
    }

    /**
     * The head of a class.
     *
     * @param draws whether it needs the generator of choices
     */
    public static HeadView of(FileContext context, boolean draws) {
        Component component = context.component();
        return new HeadView(
                context.self(),
                component.qualifiedName(),
                Places.file(component),
                Places.line(component.span()),
                draws,
                mentions(context),
                component.parameters().stream().map(p -> parameter(context, p)).toList(),
                component.inputs().stream().map(p -> port(context, p)).toList(),
                component.outputs().stream().map(p -> port(context, p)).toList());
    }

    private static FieldView parameter(FileContext context, Parameter parameter) {
        return new FieldView(
                context.expressions().type(parameter.type()),
                context.members().of(parameter),
                "",
                parameter.type().name() + " " + parameter.name());
    }

    private static PortView port(FileContext context, Port port) {
        String total = port.total() ? "total " : ""; // no stereotype: doc comments are HTML
        String direction = port.isInput() ? "in " : "out ";
        return new PortView(
                context.members().of(port),
                context.expressions().type(port.type()),
                context.members().flag(port),
                context.names().language().kind(port.type()),
                port.total(),
                port.delay(),
                total + direction + port.type().simpleName() + " " + port.name());
    }

    private static List<TypeView> mentions(FileContext context) {
        Set<TypeName> components =
                context.composition().stream()
                        .flatMap(inside -> inside.nodes().stream())
                        .map(node -> context.names().of(node.component()))
                        .collect(Collectors.toSet());
        List<Type> types = MentionedTypes.of(context.component(), context.composition());
        return mentions(context.references(), components, context.names().ofEnums(types));
    }

    /** The types that a file mentions, each with its kind. */
    static List<TypeView> mentions(
            FileReferences references, Set<TypeName> components, Set<TypeName> enums) {
        return references.mentioned().stream()
                .map(
                        type ->
                                new TypeView(
                                        type,
                                        references.isNeighbour(type),
                                        components.contains(type)
                                                ? "component"
                                                : enums.contains(type) ? "enum" : "class"))
                .toList();
    }
}
