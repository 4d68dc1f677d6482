package arcomat.check.walk;

import arcomat.check.law.Carrier;
import arcomat.check.law.Check.Context;
import arcomat.tree.Behaviour;
import arcomat.tree.Component;
import arcomat.tree.Element;

/**
 * The part of the walk that goes through the text of a component for types and stereotypes, which
 * stand on declarations that may declare several things.
 */
record ElementWalk(StereotypeWalk stereotypes, ExpressionWalk expressions, Context context)
        implements Element.Visitor {
    @Override
    public void ports(Element.Ports ports) {
        stereotypes.visit(ports.stereotypes(), Carrier.PORT, ports, context);
        for (Element.Port port : ports.ports()) {
            stereotypes.visit(port.stereotypes(), Carrier.PORT, port, context);
            expressions.type(port.type(), context);
        }
    }

    @Override
    public void subcomponent(Element.Subcomponent subcomponent) {
        stereotypes.visit(subcomponent.stereotypes(), Carrier.SUBCOMPONENT, subcomponent, context);
        expressions.componentType(subcomponent.type(), context);
        for (Element.Instance instance : subcomponent.instances()) {
            for (Element.SimpleConnector connector : instance.connectors()) {
                stereotypes.visit(connector.stereotypes(), Carrier.CONNECTOR, connector, context);
            }
        }
    }

    @Override
    public void connector(Element.Connector connector) {
        stereotypes.visit(connector.stereotypes(), Carrier.CONNECTOR, connector, context);
    }

    @Override
    public void timing(Element.Timing timing) {
        stereotypes.visit(timing.stereotypes(), Carrier.TIMING, timing, context);
    }

    @Override
    public void autoconnect(Element.Autoconnect clause) {
        stereotypes.visit(clause.stereotypes(), Carrier.AUTOCONNECT, clause, context);
    }

    @Override
    public void autoinstantiate(Element.Autoinstantiate clause) {
        stereotypes.visit(clause.stereotypes(), Carrier.AUTOINSTANTIATE, clause, context);
    }

    @Override
    public void variables(Element.Variables variables) {
        expressions.type(variables.type(), context);
    }

    /** Walked as a component of its own. */
    @Override
    public void component(Component component) {}

    /** Walked with its symbol. */
    @Override
    public void behaviour(Behaviour behaviour) {}

    /** Walked with its symbol. */
    @Override
    public void invariant(Element.Invariant invariant) {}

    /** The laws about features ask the text. */
    @Override
    public void features(Element.Features features) {}

    @Override
    public void constraint(Element.Constraint constraint) {}

    /** What a configuration has of it stands among the elements. */
    @Override
    public void variation(Element.Variation variation) {}

    /** Walked with the automaton that it is the start of. */
    @Override
    public void start(Element.Start start) {}

    /** Has neither types nor stereotypes that are looked at. */
    @Override
    public void javaPart(Element.JavaPart part) {}
}
