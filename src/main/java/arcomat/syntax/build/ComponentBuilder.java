package arcomat.syntax.build;

import arcomat.source.Span;
import arcomat.syntax.antlr.ArcomatParser;
import arcomat.tree.Automaton;
import arcomat.tree.Behaviour;
import arcomat.tree.Component;
import arcomat.tree.Component.Parameter;
import arcomat.tree.Component.TypeParameter;
import arcomat.tree.Element;
import arcomat.tree.Name;

import org.antlr.v4.runtime.ParserRuleContext;
import org.antlr.v4.runtime.Token;

import java.util.List;
import java.util.Locale;
import java.util.Optional;

/** Component types, and what stands in their bodies: each behaviour language is one method. */
final class ComponentBuilder extends TreeBuilder<Element> {
    private final AutomatonBuilder automata;
    private final Computations computations;
    private final List<Token> tokens;
    private final List<Span> gaps;

    /**
     * @param tokens all those of the file
     * @param gaps what is left out of it
     */
    ComponentBuilder(
            Phrases phrases, AutomatonBuilder automata, List<Token> tokens, List<Span> gaps) {
        super(phrases);
        this.automata = automata;
        this.computations = new Computations(phrases, automata.statements, tokens);
        this.tokens = tokens;
        this.gaps = gaps;
    }

    // ---- components -----------------------------------------------------------------------

    Component component(ArcomatParser.ComponentContext context) {
        ArcomatParser.ParametersContext parameters = context.parameters();
        ArcomatParser.TypeParametersContext typeParameters = context.typeParameters();
        return new Component(
                span(context),
                phrases.stereotypes(context.stereotypes()),
                hasModifier(context, "abstract"),
                hasModifier(context, "deploy"),
                phrases.name(context.name()),
                typeParameters == null
                        ? List.of()
                        : each(typeParameters.typeParameter(), this::typeParameter),
                parameters == null ? List.of() : each(parameters.parameter(), this::parameter),
                optional(context.superType, phrases::type),
                optional(context.superArguments, phrases.expressions::given),
                each(context.refined, this::refined),
                optional(context.namedInstance(), this::namedInstance),
                Computations.begun(buildAll(context.element())));
    }

    private Component.Refined refined(ArcomatParser.RefinedComponentContext context) {
        return new Component.Refined(
                span(context),
                phrases.qualifiedName(context.qualifiedName()),
                optional(context.componentArguments(), phrases.expressions::given)
                        .orElse(List.of()));
    }

    private static boolean hasModifier(ArcomatParser.ComponentContext context, String word) {
        for (ArcomatParser.ModifierContext modifier : context.modifier()) {
            if (modifier.start.getText().equals(word)) {
                return true;
            }
        }
        return false;
    }

    private TypeParameter typeParameter(ArcomatParser.TypeParameterContext context) {
        return new TypeParameter(
                span(context), phrases.name(context.name()), phrases.types(context.type()));
    }

    private Parameter parameter(ArcomatParser.ParameterContext context) {
        return new Parameter(
                span(context),
                phrases.type(context.type()),
                phrases.name(context.name()),
                optional(context.expression(), phrases.expressions::build));
    }

    private Component.NamedInstance namedInstance(ArcomatParser.NamedInstanceContext context) {
        return new Component.NamedInstance(
                span(context),
                phrases.name(context.name()),
                phrases.typeArguments(context.typeArguments()));
    }

    // ---- elements -------------------------------------------------------------------------

    @Override
    public Element visitElement(ArcomatParser.ElementContext context) {
        return buildSole(context);
    }

    @Override
    public Element visitBehaviour(ArcomatParser.BehaviourContext context) {
        return buildSole(context);
    }

    @Override
    public Element visitComponent(ArcomatParser.ComponentContext context) {
        return component(context);
    }

    @Override
    public Element visitPorts(ArcomatParser.PortsContext context) {
        return new Element.Ports(
                span(context),
                phrases.stereotypes(context.stereotypes()),
                each(context.port(), this::port));
    }

    private Element.Port port(ArcomatParser.PortContext context) {
        boolean in = context.direction.getText().equals("in");
        return new Element.Port(
                span(context),
                phrases.stereotypes(context.stereotypes()),
                in ? Element.Direction.IN : Element.Direction.OUT,
                phrases.type(context.type()),
                names(context));
    }

    private List<Name> names(ArcomatParser.PortContext context) {
        return context.declared().stream().flatMap(each -> names(context, each).stream()).toList();
    }

    /** A size behind the type is that of each name without one. */
    private List<Name> names(
            ArcomatParser.PortContext context, ArcomatParser.DeclaredContext declared) {
        return context.size() == null || declared.size() != null
                ? phrases.declared(declared)
                : phrases.elements(
                        span(context.size().start, declared.stop), declared, context.size());
    }

    @Override
    public Element visitSubcomponent(ArcomatParser.SubcomponentContext context) {
        return new Element.Subcomponent(
                span(context),
                phrases.stereotypes(context.stereotypes()),
                phrases.type(context.type()),
                phrases.expressions.given(context.componentArguments()),
                context.instance().stream().flatMap(each -> instances(each).stream()).toList());
    }

    private List<Element.Instance> instances(ArcomatParser.InstanceContext context) {
        List<Element.SimpleConnector> connectors =
                each(context.simpleConnector(), this::simpleConnector);
        return phrases.declared(context.declared()).stream()
                .map(name -> new Element.Instance(span(context), name, connectors))
                .toList();
    }

    private Element.SimpleConnector simpleConnector(ArcomatParser.SimpleConnectorContext context) {
        return new Element.SimpleConnector(
                span(context),
                phrases.stereotypes(context.stereotypes()),
                phrases.qualifiedPlace(context.source),
                phrases.qualifiedPlaces(context.targets));
    }

    @Override
    public Element visitConnector(ArcomatParser.ConnectorContext context) {
        return new Element.Connector(
                span(context),
                phrases.stereotypes(context.stereotypes()),
                phrases.qualifiedPlace(context.source),
                phrases.qualifiedPlaces(context.targets));
    }

    @Override
    public Element visitTiming(ArcomatParser.TimingContext context) {
        return new Element.Timing(
                span(context),
                phrases.stereotypes(context.stereotypes()),
                named(Element.TimingKind.class, context.kind));
    }

    @Override
    public Element visitAutoconnect(ArcomatParser.AutoconnectContext context) {
        return new Element.Autoconnect(
                span(context),
                phrases.stereotypes(context.stereotypes()),
                named(Element.AutoconnectKind.class, context.kind));
    }

    private static <E extends Enum<E>> E named(Class<E> kinds, Token word) {
        return Enum.valueOf(kinds, word.getText().toUpperCase(Locale.ROOT));
    }

    @Override
    public Element visitAutoinstantiate(ArcomatParser.AutoinstantiateContext context) {
        return new Element.Autoinstantiate(
                span(context),
                phrases.stereotypes(context.stereotypes()),
                context.kind.getText().equals("on"));
    }

    @Override
    public Element visitInvariant(ArcomatParser.InvariantContext context) {
        return new Element.Invariant(
                span(context),
                optional(context.kind, phrases::name),
                phrases.name(context.title),
                phrases.text(context.invariantBody()),
                InvariantBody.condition(context.invariantBody(), tokens)
                        .map(phrases.expressions::build));
    }

    @Override
    public Element visitMarkedVariables(ArcomatParser.MarkedVariablesContext context) {
        return new Element.Variables(
                span(context), phrases.type(context.type()), phrases.variables(context.variable()));
    }

    @Override
    public Element visitPlainVariables(ArcomatParser.PlainVariablesContext context) {
        return new Element.Variables(
                span(context),
                phrases.type(context.plainType()),
                phrases.variables(context.variable()));
    }

    @Override
    public Element visitFeatures(ArcomatParser.FeaturesContext context) {
        return new Element.Features(span(context), phrases.names(context.name()));
    }

    @Override
    public Element visitConstraint(ArcomatParser.ConstraintContext context) {
        return new Element.Constraint(
                span(context), phrases.expressions.build(context.expression()));
    }

    @Override
    public Element visitVariation(ArcomatParser.VariationContext context) {
        return new Element.Variation(
                span(context),
                phrases.expressions.build(context.expression()),
                Computations.begun(buildAll(context.element())),
                context.alternative() == null ? List.of() : alternative(context.alternative()));
    }

    private List<Element> alternative(ArcomatParser.AlternativeContext context) {
        return context.variation() == null
                ? Computations.begun(buildAll(context.element()))
                : List.of(visitVariation(context.variation()));
    }

    // ---- behaviour languages --------------------------------------------------------------

    @Override
    public Element visitAutomaton(ArcomatParser.AutomatonContext context) {
        return automata.automaton(context);
    }

    @Override
    public Element visitIoTable(ArcomatParser.IoTableContext context) {
        return foreign(
                context,
                context.stereotypes(),
                phrases.name(context.keyword),
                Optional.empty(),
                span(context.open, context.stop));
    }

    @Override
    public Element visitComputation(ArcomatParser.ComputationContext context) {
        return computations.element(context);
    }

    @Override
    public Element visitImplementation(ArcomatParser.ImplementationContext context) {
        return new Behaviour.Implementation(
                span(context), phrases.optionalName(context.name()), automata(context));
    }

    @Override
    public Element visitForeign(ArcomatParser.ForeignContext context) {
        return foreign(
                context,
                context.stereotypes(),
                phrases.name(context.keyword),
                phrases.optionalName(context.name()),
                span(context.javaBlock()));
    }

    private Behaviour.Foreign foreign(
            ParserRuleContext context,
            ArcomatParser.StereotypesContext stereotypes,
            Name keyword,
            Optional<Name> name,
            Span braces) {
        Span body = new Span(braces.file(), braces.start() + 1, braces.end() - 1);
        return new Behaviour.Foreign(
                span(context),
                phrases.stereotypes(stereotypes),
                keyword,
                name,
                body,
                gaps.stream().filter(body::isAround).toList(),
                List.of());
    }

    private List<Automaton> automata(ArcomatParser.ImplementationContext context) {
        List<ArcomatParser.AutomatonElementContext> bare = context.automatonElement();
        if (bare.isEmpty()) {
            return each(context.automaton(), automata::automaton);
        }
        Span span = span(bare.get(0).start, bare.get(bare.size() - 1).stop);
        return List.of(new Automaton(span, List.of(), Optional.empty(), automata.buildAll(bare)));
    }
}
