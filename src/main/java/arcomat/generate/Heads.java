package arcomat.generate;

import arcomat.generate.language.Language;
import arcomat.generate.language.References;
import arcomat.generate.language.TypeName;
import arcomat.generate.view.FieldView;
import arcomat.generate.view.HeadView;
import arcomat.generate.view.PortView;
import arcomat.generate.view.TypeView;
import arcomat.model.Component;
import arcomat.model.Parameter;
import arcomat.model.Port;
import arcomat.model.Type;
import arcomat.semantics.network.Composition;

import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Set;

/** What all views of components have in common. */
final class Heads {
    private Heads() {}

    static HeadView of(FileContext context, boolean draws) {
        Component component = context.component();
        TypeName self = context.self();
        return new HeadView(
                self.packageName(),
                self.prefix(),
                self.folder(),
                self.name(),
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
                Language.kind(port.type()),
                port.total(),
                port.delay(),
                total + direction + port.type().simpleName() + " " + port.name());
    }

    private static List<TypeView> mentions(FileContext context) {
        Set<TypeName> components = new HashSet<>();
        context.composition()
                .ifPresent(
                        c -> {
                            for (Composition.Node node : c.nodes()) {
                                components.add(context.names().of(node.component()));
                            }
                        });
        Set<TypeName> enums = new HashSet<>();
        for (Type type : MentionedTypes.of(context.component(), context.composition())) {
            if (type instanceof Type.EnumType) {
                enums.add(context.names().of(type));
            }
        }
        return mentions(context.references(), components, enums);
    }

    static List<TypeView> mentions(
            References references, Set<TypeName> components, Set<TypeName> enums) {
        List<TypeView> views = new ArrayList<>();
        for (TypeName type : references.mentioned()) {
            String kind =
                    components.contains(type)
                            ? "component"
                            : enums.contains(type) ? "enum" : "class";
            views.add(
                    new TypeView(
                            type.packageName(),
                            type.prefix(),
                            type.folder(),
                            type.name(),
                            references.isNeighbour(type),
                            kind));
        }
        return views;
    }
}
