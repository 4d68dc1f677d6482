package arcomat.syntax.build;

import arcomat.syntax.antlr.ArcomatParser.ComponentContext;
import arcomat.syntax.antlr.ArcomatParser.ModifierContext;
import arcomat.syntax.antlr.ArcomatParser.NamedInstanceContext;
import arcomat.syntax.antlr.ArcomatParser.ParameterContext;
import arcomat.syntax.antlr.ArcomatParser.ParametersContext;
import arcomat.syntax.antlr.ArcomatParser.TypeParameterContext;
import arcomat.syntax.antlr.ArcomatParser.TypeParametersContext;
import arcomat.tree.Component;
import arcomat.tree.Component.NamedInstance;
import arcomat.tree.Parameter;
import arcomat.tree.TypeParameter;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;

/** Component types: the head here, the body by {@link ElementBuilder}. */
final class ComponentBuilder extends TreeBuilder<Component> {
    private final Phrases phrases;
    private final ElementBuilder elements;

    ComponentBuilder(Phrases phrases, BehaviourBuilder behaviours) {
        super(phrases.texts);
        this.phrases = phrases;
        this.elements = new ElementBuilder(phrases, behaviours, this);
    }

    @Override
    public Component visitComponent(ComponentContext context) {
        return new Component(
                span(context),
                phrases.stereotypes.stereotypes(context.stereotypes()),
                hasModifier(context, "abstract"),
                hasModifier(context, "deploy"),
                phrases.names.build(context.name()),
                typeParameters(context.typeParameters()),
                parameters(context.parameters()),
                phrases.types.buildOptional(context.superType),
                phrases.qualifiedNames.buildAll(context.refined),
                namedInstance(context.namedInstance()),
                elements.buildAll(context.element()));
    }

    private static boolean hasModifier(ComponentContext context, String word) {
        for (ModifierContext modifier : context.modifier()) {
            if (modifier.getText().equals(word)) {
                return true;
            }
        }
        return false;
    }

    private List<TypeParameter> typeParameters(TypeParametersContext context) {
        if (context == null) {
            return List.of();
        }
        List<TypeParameter> parameters = new ArrayList<>();
        for (TypeParameterContext parameter : context.typeParameter()) {
            parameters.add(
                    new TypeParameter(
                            span(parameter),
                            phrases.names.build(parameter.name()),
                            phrases.types.buildAll(parameter.type())));
        }
        return parameters;
    }

    private List<Parameter> parameters(ParametersContext context) {
        if (context == null) {
            return List.of();
        }
        List<Parameter> parameters = new ArrayList<>();
        for (ParameterContext parameter : context.parameter()) {
            parameters.add(
                    new Parameter(
                            span(parameter),
                            phrases.types.build(parameter.type()),
                            phrases.names.build(parameter.name()),
                            phrases.expressions.buildOptional(parameter.expression())));
        }
        return parameters;
    }

    private Optional<NamedInstance> namedInstance(NamedInstanceContext context) {
        if (context == null) {
            return Optional.empty();
        }
        return Optional.of(
                new NamedInstance(
                        span(context),
                        phrases.names.build(context.name()),
                        phrases.types.typeArguments.arguments(context.typeArguments())));
    }
}
