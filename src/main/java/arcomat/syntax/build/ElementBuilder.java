package arcomat.syntax.build;

import arcomat.source.Span;
import arcomat.syntax.antlr.ArcomatParser.AutoconnectContext;
import arcomat.syntax.antlr.ArcomatParser.AutoinstantiateContext;
import arcomat.syntax.antlr.ArcomatParser.BehaviourContext;
import arcomat.syntax.antlr.ArcomatParser.ComponentContext;
import arcomat.syntax.antlr.ArcomatParser.ConnectorContext;
import arcomat.syntax.antlr.ArcomatParser.ElementContext;
import arcomat.syntax.antlr.ArcomatParser.InstanceContext;
import arcomat.syntax.antlr.ArcomatParser.InvariantContext;
import arcomat.syntax.antlr.ArcomatParser.JavaPartContext;
import arcomat.syntax.antlr.ArcomatParser.MarkedVariablesContext;
import arcomat.syntax.antlr.ArcomatParser.PlainVariablesContext;
import arcomat.syntax.antlr.ArcomatParser.PortContext;
import arcomat.syntax.antlr.ArcomatParser.PortsContext;
import arcomat.syntax.antlr.ArcomatParser.SimpleConnectorContext;
import arcomat.syntax.antlr.ArcomatParser.SubcomponentContext;
import arcomat.syntax.antlr.ArcomatParser.TimingContext;
import arcomat.tree.Element;
import arcomat.tree.Element.Autoconnect;
import arcomat.tree.Element.AutoconnectKind;
import arcomat.tree.Element.Autoinstantiate;
import arcomat.tree.Element.Connector;
import arcomat.tree.Element.Direction;
import arcomat.tree.Element.Instance;
import arcomat.tree.Element.Invariant;
import arcomat.tree.Element.JavaPart;
import arcomat.tree.Element.Port;
import arcomat.tree.Element.Ports;
import arcomat.tree.Element.SimpleConnector;
import arcomat.tree.Element.Subcomponent;
import arcomat.tree.Element.Timing;
import arcomat.tree.Element.TimingKind;
import arcomat.tree.Element.Variables;

import org.antlr.v4.runtime.ParserRuleContext;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Optional;

/** What stands in the body of a component. */
final class ElementBuilder extends TreeBuilder<Element> {
    private final Phrases phrases;
    private final BehaviourBuilder behaviours;
    private final ComponentBuilder components;

    ElementBuilder(Phrases phrases, BehaviourBuilder behaviours, ComponentBuilder components) {
        super(phrases.texts);
        this.phrases = phrases;
        this.behaviours = behaviours;
        this.components = components;
    }

    @Override
    public Element visitElement(ElementContext context) {
        return build((ParserRuleContext) context.getChild(0));
    }

    @Override
    public Element visitComponent(ComponentContext context) {
        return components.build(context);
    }

    @Override
    public Element visitBehaviour(BehaviourContext context) {
        return behaviours.build((ParserRuleContext) context.getChild(0));
    }

    @Override
    public Element visitPorts(PortsContext context) {
        List<Port> ports = new ArrayList<>();
        for (PortContext port : context.port()) {
            ports.add(port(port));
        }
        return new Ports(
                span(context), phrases.stereotypes.stereotypes(context.stereotypes()), ports);
    }

    private Port port(PortContext context) {
        boolean in = context.direction.getText().equals("in");
        return new Port(
                span(context),
                phrases.stereotypes.stereotypes(context.stereotypes()),
                in ? Direction.IN : Direction.OUT,
                phrases.types.build(context.type()),
                phrases.names.buildAll(context.name()));
    }

    @Override
    public Element visitSubcomponent(SubcomponentContext context) {
        List<Instance> instances = new ArrayList<>();
        for (InstanceContext instance : context.instance()) {
            instances.add(instance(instance));
        }
        return new Subcomponent(
                span(context),
                phrases.stereotypes.stereotypes(context.stereotypes()),
                phrases.types.build(context.type()),
                phrases.expressions.arguments(context.arguments()),
                instances);
    }

    private Instance instance(InstanceContext context) {
        List<SimpleConnector> connectors = new ArrayList<>();
        for (SimpleConnectorContext connector : context.simpleConnector()) {
            connectors.add(
                    new SimpleConnector(
                            span(connector),
                            phrases.stereotypes.stereotypes(connector.stereotypes()),
                            phrases.qualifiedNames.build(connector.source),
                            phrases.qualifiedNames.buildAll(connector.targets)));
        }
        return new Instance(span(context), phrases.names.build(context.name()), connectors);
    }

    @Override
    public Element visitConnector(ConnectorContext context) {
        return new Connector(
                span(context),
                phrases.stereotypes.stereotypes(context.stereotypes()),
                phrases.qualifiedNames.build(context.source),
                phrases.qualifiedNames.buildAll(context.targets));
    }

    @Override
    public Element visitTiming(TimingContext context) {
        return new Timing(
                span(context),
                phrases.stereotypes.stereotypes(context.stereotypes()),
                TimingKind.valueOf(context.kind.getText().toUpperCase(Locale.ROOT)));
    }

    @Override
    public Element visitAutoconnect(AutoconnectContext context) {
        return new Autoconnect(
                span(context),
                phrases.stereotypes.stereotypes(context.stereotypes()),
                AutoconnectKind.valueOf(context.kind.getText().toUpperCase(Locale.ROOT)));
    }

    @Override
    public Element visitAutoinstantiate(AutoinstantiateContext context) {
        return new Autoinstantiate(
                span(context),
                phrases.stereotypes.stereotypes(context.stereotypes()),
                context.kind.getText().equals("on"));
    }

    @Override
    public Element visitInvariant(InvariantContext context) {
        return new Invariant(
                span(context),
                context.kind == null
                        ? Optional.empty()
                        : Optional.of(phrases.names.name(context.kind)),
                phrases.names.build(context.title),
                span(context.invariantBody()).text(),
                new InvariantBody(phrases.expressions).condition(context.invariantBody()));
    }

    @Override
    public Element visitMarkedVariables(MarkedVariablesContext context) {
        return variables(context, context.type(), context.variable());
    }

    @Override
    public Element visitPlainVariables(PlainVariablesContext context) {
        return variables(context, context.plainType(), context.variable());
    }

    private Element variables(
            ParserRuleContext context,
            ParserRuleContext type,
            List<? extends ParserRuleContext> variables) {
        return new Variables(
                span(context), phrases.types.build(type), phrases.variables.buildAll(variables));
    }

    @Override
    public Element visitJavaPart(JavaPartContext context) {
        Span text = span(context.javaBlock());
        return new JavaPart(
                span(context),
                context.keyword.getText(),
                phrases.names.buildOptional(context.name()),
                text.text());
    }
}
