package arcomat.syntax.build;

import arcomat.syntax.antlr.ArcomatParser;
import arcomat.tree.ClassDiagram;

/** Class diagrams and their types. */
final class ClassDiagramBuilder extends TreeBuilder<ClassDiagram.TypeDefinition> {
    ClassDiagramBuilder(Phrases phrases) {
        super(phrases);
    }

    ClassDiagram classDiagram(ArcomatParser.ClassDiagramContext context) {
        return new ClassDiagram(
                span(context), phrases.name(context.name()), buildAll(context.typeDefinition()));
    }

    @Override
    public ClassDiagram.TypeDefinition visitEnumDefinition(
            ArcomatParser.EnumDefinitionContext context) {
        return new ClassDiagram.EnumDefinition(
                span(context), phrases.name(context.name(0)), phrases.names(context.constants));
    }

    @Override
    public ClassDiagram.TypeDefinition visitClassDefinition(
            ArcomatParser.ClassDefinitionContext context) {
        return new ClassDiagram.ClassDefinition(
                span(context),
                phrases.name(context.name()),
                optional(context.type(), phrases::type),
                each(context.attribute(), this::attribute));
    }

    private ClassDiagram.Attribute attribute(ArcomatParser.AttributeContext context) {
        return new ClassDiagram.Attribute(
                span(context), phrases.type(context.type()), phrases.name(context.name()));
    }
}
