package arcomat.syntax.build;

import arcomat.syntax.antlr.ArcomatParser.AttributeContext;
import arcomat.syntax.antlr.ArcomatParser.ClassDefinitionContext;
import arcomat.syntax.antlr.ArcomatParser.ClassDiagramContext;
import arcomat.syntax.antlr.ArcomatParser.EnumDefinitionContext;
import arcomat.tree.ClassDiagram;
import arcomat.tree.ClassDiagram.Attribute;
import arcomat.tree.ClassDiagram.ClassDefinition;
import arcomat.tree.ClassDiagram.EnumDefinition;
import arcomat.tree.ClassDiagram.TypeDefinition;

import java.util.ArrayList;
import java.util.List;

/** Class diagrams and their types. */
final class ClassDiagramBuilder extends TreeBuilder<TypeDefinition> {
    ClassDiagramBuilder(Builders builders) {
        super(builders);
    }

    ClassDiagram classDiagram(ClassDiagramContext context) {
        return new ClassDiagram(
                span(context),
                builders.names.build(context.name()),
                buildAll(context.typeDefinition()));
    }

    @Override
    public TypeDefinition visitEnumDefinition(EnumDefinitionContext context) {
        return new EnumDefinition(
                span(context),
                builders.names.build(context.name(0)),
                builders.names.buildAll(context.constants));
    }

    @Override
    public TypeDefinition visitClassDefinition(ClassDefinitionContext context) {
        List<Attribute> attributes = new ArrayList<>();
        for (AttributeContext attribute : context.attribute()) {
            attributes.add(
                    new Attribute(
                            span(attribute),
                            builders.types.build(attribute.type()),
                            builders.names.build(attribute.name())));
        }
        return new ClassDefinition(
                span(context),
                builders.names.build(context.name()),
                builders.types.buildOptional(context.type()),
                attributes);
    }
}
