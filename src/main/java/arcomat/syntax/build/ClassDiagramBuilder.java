package arcomat.syntax.build;

import arcomat.syntax.antlr.ArcomatParser;
import arcomat.tree.ClassDiagram;
import arcomat.tree.ClassDiagram.Association;
import arcomat.tree.ClassDiagram.AssociationEnd;
import arcomat.tree.ClassDiagram.ConstantArguments;
import arcomat.tree.ClassDiagram.Entry;
import arcomat.tree.ClassDiagram.Member;
import arcomat.tree.ClassDiagram.TypeDefinition;
import arcomat.tree.Name;
import arcomat.tree.TypeReference;

import org.antlr.v4.runtime.ParserRuleContext;
import org.jspecify.annotations.Nullable;

import java.util.List;
import java.util.Optional;

/** Class diagrams and their types; what is between the braces of a type by another one. */
final class ClassDiagramBuilder extends TreeBuilder<Entry> {
    private final MemberBuilder members;

    ClassDiagramBuilder(Phrases phrases) {
        super(phrases);
        this.members = new MemberBuilder(phrases);
    }

    ClassDiagram classDiagram(ArcomatParser.ClassDiagramContext context) {
        List<Entry> entries = buildAll(context.typeDefinition());
        return new ClassDiagram(
                span(context),
                phrases.stereotypes(context.stereotypes()),
                phrases.name(context.name()),
                those(TypeDefinition.class, entries),
                those(Association.class, entries));
    }

    private static <T extends Entry> List<T> those(Class<T> form, List<Entry> entries) {
        return entries.stream().filter(form::isInstance).map(form::cast).toList();
    }

    @Override
    public Entry visitEnumDefinition(ArcomatParser.EnumDefinitionContext context) {
        return new ClassDiagram.EnumDefinition(
                span(context),
                phrases.stereotypes(context.stereotypes()),
                members.modifiers(context.typeModifier()),
                phrases.name(context.name()),
                implemented(context.implemented()),
                each(context.enumConstant(), each -> phrases.name(each.name())),
                context.enumConstant().stream()
                        .filter(each -> each.arguments() != null)
                        .map(this::constantArguments)
                        .toList(),
                members.buildAll(context.typeMember()));
    }

    private ConstantArguments constantArguments(ArcomatParser.EnumConstantContext context) {
        return new ConstantArguments(
                span(context.arguments()),
                phrases.name(context.name()),
                phrases.expressions.arguments(context.arguments()));
    }

    @Override
    public Entry visitClassDefinition(ArcomatParser.ClassDefinitionContext context) {
        return new ClassDiagram.ClassDefinition(
                span(context),
                phrases.stereotypes(context.stereotypes()),
                members.modifiers(context.typeModifier()),
                phrases.name(context.name()),
                optional(context.type(), phrases::type),
                implemented(context.implemented()),
                body(context.typeBody()));
    }

    @Override
    public Entry visitInterfaceDefinition(ArcomatParser.InterfaceDefinitionContext context) {
        return new ClassDiagram.InterfaceDefinition(
                span(context),
                phrases.stereotypes(context.stereotypes()),
                members.modifiers(context.typeModifier()),
                phrases.name(context.name()),
                phrases.types(context.type()),
                body(context.typeBody()));
    }

    @Override
    public Entry visitOpaqueDefinition(ArcomatParser.OpaqueDefinitionContext context) {
        return new ClassDiagram.OpaqueDefinition(
                span(context),
                phrases.stereotypes(context.stereotypes()),
                phrases.name(context.name()));
    }

    private List<TypeReference> implemented(ArcomatParser.@Nullable ImplementedContext context) {
        return context == null ? List.of() : phrases.types(context.type());
    }

    /** Where nothing but its semicolon is missing, there is none, and the rest is read. */
    private List<Member> body(ArcomatParser.@Nullable TypeBodyContext context) {
        return context == null ? List.of() : members.buildAll(context.typeMember());
    }

    // ---- associations ---------------------------------------------------------------------

    @Override
    public Entry visitAssociationDefinition(ArcomatParser.AssociationDefinitionContext context) {
        return new Association(
                span(context),
                phrases.stereotypes(context.stereotypes()),
                members.modifiers(context.typeModifier()),
                context.kind.getText(),
                phrases.optionalName(context.name()),
                left(context.leftEnd()),
                text(context.associationArrow()),
                right(context.rightEnd()));
    }

    private AssociationEnd left(ArcomatParser.LeftEndContext context) {
        return new AssociationEnd(
                span(context),
                phrases.type(context.qualifiedName()),
                optional(context.cardinality(), this::text),
                optional(context.qualifier(), this::text),
                role(context.role()));
    }

    private AssociationEnd right(ArcomatParser.RightEndContext context) {
        return new AssociationEnd(
                span(context),
                phrases.type(context.qualifiedName()),
                optional(context.cardinality(), this::text),
                optional(context.qualifier(), this::text),
                role(context.role()));
    }

    private Optional<Name> role(ArcomatParser.@Nullable RoleContext context) {
        return context == null ? Optional.empty() : Optional.of(phrases.name(context.name()));
    }

    /** Without the spaces in it. */
    private String text(ParserRuleContext context) {
        return phrases.text(context).replaceAll("\\s+", "");
    }
}
