package arcomat.symbols.occurrences;

import arcomat.source.ArrayNames;
import arcomat.source.Span;
import arcomat.symbols.bodies.AutomatonSymbol;
import arcomat.symbols.bodies.ComponentSymbol;
import arcomat.symbols.bodies.ConnectorSymbol;
import arcomat.symbols.bodies.ConnectorSymbol.End;
import arcomat.symbols.bodies.ConnectorSymbol.Status;
import arcomat.symbols.bodies.InstanceSymbol;
import arcomat.symbols.bodies.InvariantSymbol;
import arcomat.symbols.expressions.DeclaredValue;
import arcomat.symbols.expressions.ParameterSymbol;
import arcomat.symbols.expressions.PortSymbol;
import arcomat.symbols.expressions.VariableSymbol;
import arcomat.symbols.names.EnumSymbol;
import arcomat.symbols.names.TypeVariable;
import arcomat.symbols.occurrences.Occurrence.Role;
import arcomat.symbols.signatures.ComponentReference;
import arcomat.symbols.signatures.Signature;
import arcomat.tree.Behaviour;
import arcomat.tree.Component;
import arcomat.tree.Element;
import arcomat.tree.Name;
import arcomat.tree.Node;
import arcomat.tree.QualifiedName;
import arcomat.tree.Stereotype;

import java.util.ArrayList;
import java.util.IdentityHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;

/** Names in a component and in those inside it. */
final class ComponentPlaces implements Element.Visitor {
    private final NamePlaces places;
    private final ComponentSymbol component;
    private final Signature signature;
    private final ExpressionPlaces expressions;
    private final FeaturePlaces features;
    private final Map<Node, List<ConnectorSymbol>> connectors = new IdentityHashMap<>();

    private ComponentPlaces(NamePlaces places, ComponentSymbol component) {
        this.places = places;
        this.component = component;
        this.signature = component.signature();
        this.expressions =
                new ExpressionPlaces(places, component::resolveType, Optional.of(component));
        this.features = FeaturePlaces.in(signature, places);
        component
                .connectors()
                .forEach(
                        each ->
                                connectors
                                        .computeIfAbsent(each.node(), any -> new ArrayList<>())
                                        .add(each));
    }

    static void in(ComponentSymbol component, NamePlaces places) {
        ComponentPlaces walk = new ComponentPlaces(places, component);
        walk.head();
        walk.members();
        walk.parts();
        walk.features();
        component.node().elements().forEach(element -> element.accept(walk));
        walk.bodies();
        component.innerComponents().forEach(inner -> in(inner, places));
    }

    private void head() {
        Component node = component.node();
        places.declared(component.nameSpan(), new Referent.Component(signature));
        for (TypeVariable variable : signature.typeParameters()) {
            places.declared(variable.node().name().span(), new Referent.TypeParameter(variable));
            variable.node().bounds().forEach(type -> places.type(type, component::resolveType));
        }
        node.superComponent()
                .ifPresent(
                        type -> {
                            Optional<Signature> above =
                                    signature
                                            .superComponent()
                                            .flatMap(ComponentReference::component);
                            component(type.name(), above);
                            places.arguments(type.arguments(), component::resolveType);
                            expressions.arguments(signature.superArguments());
                        });
        for (Signature.Refinement refinement : signature.refines()) {
            component(refinement.node(), refinement.resolution().found());
        }
    }

    private void component(QualifiedName name, Optional<Signature> meant) {
        meant.ifPresent(found -> places.path(name.parts(), new Referent.Component(found)));
    }

    private void members() {
        for (ParameterSymbol parameter : signature.ownParameters()) {
            places.type(parameter.node().type(), component::resolveType);
            value(parameter, new Referent.Parameter(parameter));
        }
        for (PortSymbol port : signature.ownPorts()) {
            if (!port.implicit()) {
                places.declared(port.nameSpan(), new Referent.Port(port));
            }
        }
        for (VariableSymbol variable : signature.ownVariables()) {
            value(variable, new Referent.Variable(variable));
        }
    }

    private void value(DeclaredValue value, Referent referent) {
        places.declared(value.nameSpan(), referent);
        value.initial().ifPresent(expressions::in);
    }

    /** A declaration may make several parts of one type. */
    private void parts() {
        Node last = null;
        for (InstanceSymbol part : component.ownInstances()) {
            if (part.origin() == InstanceSymbol.Origin.NAMED) {
                places.declared(part.nameSpan(), new Referent.Part(part));
            }
            if (part.node() != last) {
                expressions.arguments(part.arguments());
                part(part);
            }
            last = part.node();
        }
    }

    private void features() {
        if (signature.enclosing().isEmpty()) {
            features.declaredBy(signature.declaration());
        }
        component
                .node()
                .superArguments()
                .ifPresent(given -> features.arguments(given, signature.superNamed()));
    }

    private void part(InstanceSymbol part) {
        if (part.node() instanceof Element.Subcomponent node) {
            features.arguments(
                    node.arguments(),
                    signature
                            .resolveComponent(node.type().name())
                            .found()
                            .map(Signature::declaration));
            component(node.type().name(), part.type().component());
            places.arguments(node.type().arguments(), component::resolveType);
        } else {
            ((Component) part.node())
                    .instance()
                    .ifPresent(
                            named -> places.arguments(named.arguments(), component::resolveType));
        }
    }

    private void bodies() {
        for (InvariantSymbol invariant : component.ownInvariants()) {
            places.declared(invariant.nameSpan(), new Referent.Invariant(invariant));
            invariant.typed().ifPresent(expressions::in);
        }
        BehaviourPlaces behaviours = new BehaviourPlaces(places, expressions);
        NamePlaces translated = new NamePlaces();
        BehaviourPlaces meant = new BehaviourPlaces(translated, expressions.to(translated));
        for (AutomatonSymbol automaton : component.ownAutomata()) {
            // No word stands for the states of what is only meant.
            (component.isMeaning(automaton) ? meant : behaviours).automaton(automaton);
        }
        places.addNames(translated);
        component.readings().values().forEach(each -> each.names().forEach(this::named));
    }

    /** What a language says that it names, besides what is found in its meaning. */
    private void named(Span name) {
        component
                .port(name.text())
                .ifPresent(
                        port ->
                                places.add(
                                        name,
                                        new Referent.Port(port),
                                        port.isInput() ? Role.READS : Role.WRITES));
    }

    @Override
    public void ports(Element.Ports ports) {
        for (Element.Port port : ports.ports()) {
            places.type(port.type(), component::resolveType);
            first(port.stereotypes(), port);
        }
        ports.ports().stream().limit(1).forEach(port -> first(ports.stereotypes(), port));
    }

    /** What a port holds first may be a constant of an enumeration. */
    private void first(List<Stereotype> stereotypes, Element.Port port) {
        Optional<Name> written = Stereotype.find(stereotypes, "state").flatMap(Stereotype::value);
        if (written.isPresent()
                && component.resolveType(port.type()).found().orElse(null)
                        instanceof EnumSymbol type) {
            Name name = written.get();
            type.ordinal(name.text())
                    .ifPresent(
                            ordinal ->
                                    places.add(
                                            word(name),
                                            new Referent.Constant(type, ordinal),
                                            Role.REFERS));
        }
    }

    /** Without the quotes that may be around it. */
    private static Span word(Name written) {
        Span span = written.span();
        int start = span.start() + Math.max(0, span.text().indexOf(written.text()));
        return span.file().span(start, start + written.text().length());
    }

    @Override
    public void connector(Element.Connector connector) {
        connections(connector, connector.source(), connector.targets());
    }

    @Override
    public void subcomponent(Element.Subcomponent subcomponent) {
        for (Element.Instance instance : subcomponent.instances()) {
            for (Element.SimpleConnector each : instance.connectors()) {
                connections(each, each.source(), each.targets());
            }
        }
    }

    private void connections(Node node, QualifiedName source, List<QualifiedName> targets) {
        List<ConnectorSymbol> made = connectors.getOrDefault(node, List.of());
        made.forEach(each -> end(source, each.source(), Role.READS));
        for (QualifiedName target : targets) {
            made.stream()
                    .filter(each -> each.target().span().equals(target.span()))
                    .forEach(each -> end(target, each.target(), Role.WRITES));
        }
    }

    private void end(QualifiedName written, End end, Role role) {
        end.port()
                .filter(port -> end.status() != Status.COMPLETED)
                .ifPresent(
                        port -> places.add(written.last().span(), new Referent.Port(port), role));
        boolean namesPart =
                !written.isSimple()
                        || end.status() == Status.NO_SUCH_PORT
                        || end.status() == Status.COMPLETED;
        if (namesPart) {
            part(written, end)
                    .ifPresent(
                            part ->
                                    places.add(
                                            written.parts().get(0).span(),
                                            new Referent.Part(part),
                                            Role.REFERS));
        }
    }

    /** Of an array whose ports nobody knows, the first part stands for all. */
    private Optional<InstanceSymbol> part(QualifiedName written, End end) {
        String first = ArrayNames.element(written.parts().get(0).text(), 0);
        return end.instance().or(() -> component.instance(first));
    }

    @Override
    public void variables(Element.Variables variables) {
        places.type(variables.type(), component::resolveType);
    }

    @Override
    public void behaviour(Behaviour behaviour) {
        if (behaviour instanceof Behaviour.Implementation implementation) {
            implementation
                    .name()
                    .ifPresent(name -> places.declared(name.span(), new Referent.Behaviour(name)));
        }
    }

    /** Walked as a component of its own. */
    @Override
    public void component(Component inner) {}

    @Override
    public void timing(Element.Timing timing) {}

    @Override
    public void autoconnect(Element.Autoconnect clause) {}

    @Override
    public void autoinstantiate(Element.Autoinstantiate clause) {}

    /** Walked with its symbol. */
    @Override
    public void invariant(Element.Invariant invariant) {}

    /** Walked with their conditions. */
    @Override
    public void features(Element.Features features) {}

    @Override
    public void constraint(Element.Constraint constraint) {}

    /** What it holds stands among the elements. */
    @Override
    public void variation(Element.Variation variation) {}

    /** Walked with the automaton that it is the start of. */
    @Override
    public void start(Element.Start start) {}

    /** Java's names are nobody's here. */
    @Override
    public void javaPart(Element.JavaPart part) {}
}
