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
    private final Phrases phrases;

    ClassDiagramBuilder(Phrases phrases) {
        super(phrases.texts);
        this.phrases = phrases;
    }

    ClassDiagram classDiagram(ClassDiagramContext context) {
        return new ClassDiagram(
                span(context),
                phrases.names.build(context.name()),
                buildAll(context.typeDefinition()));
    }

    @Override
    public TypeDefinition visitEnumDefinition(EnumDefinitionContext context) {
        return new EnumDefinition(
                span(context),
                phrases.names.build(context.name(0)),
                phrases.names.buildAll(context.constants));
    }

    @Override
    public TypeDefinition visitClassDefinition(ClassDefinitionContext context) {
        List<Attribute> attributes = new ArrayList<>();
        for (AttributeContext attribute : context.attribute()) {
            attributes.add(
                    new Attribute(
                            span(attribute),
                            phrases.types.build(attribute.type()),
                            phrases.names.build(attribute.name())));
        }
        return new ClassDefinition(
                span(context),
                phrases.names.build(context.name()),
                phrases.types.buildOptional(context.type()),
                attributes);
    }
}
