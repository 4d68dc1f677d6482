package arcomat.syntax.build;

import arcomat.syntax.antlr.ArcomatParser;
import arcomat.tree.ClassDiagram.Attribute;
import arcomat.tree.ClassDiagram.Member;
import arcomat.tree.ClassDiagram.Method;
import arcomat.tree.ClassDiagram.MethodParameter;
import arcomat.tree.Name;

import java.util.List;

/** What is between the braces of a type in a class diagram. */
final class MemberBuilder extends TreeBuilder<Member> {
    MemberBuilder(Phrases phrases) {
        super(phrases);
    }

    List<Name> modifiers(List<ArcomatParser.TypeModifierContext> contexts) {
        return each(contexts, context -> phrases.name(context.start));
    }

    @Override
    public Member visitAttributeMember(ArcomatParser.AttributeMemberContext context) {
        return new Attribute(
                span(context),
                phrases.stereotypes(context.stereotypes()),
                modifiers(context.typeModifier()),
                phrases.type(context.type()),
                phrases.name(context.name()),
                optional(context.expression(), phrases.expressions::build));
    }

    /** A constructor has no type in front of its name. */
    @Override
    public Member visitMethodMember(ArcomatParser.MethodMemberContext context) {
        return new Method(
                span(context),
                phrases.stereotypes(context.stereotypes()),
                modifiers(context.typeModifier()),
                optional(context.result, phrases::type),
                phrases.name(context.name()),
                each(context.methodParameters().methodParameter(), this::parameter),
                phrases.types(context.thrown),
                optional(context.javaBlock(), phrases::text));
    }

    private MethodParameter parameter(ArcomatParser.MethodParameterContext context) {
        return new MethodParameter(
                span(context), phrases.type(context.type()), phrases.name(context.name()));
    }
}
