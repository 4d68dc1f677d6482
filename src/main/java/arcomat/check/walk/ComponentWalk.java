package arcomat.check.walk;

import arcomat.check.facts.Connections;
import arcomat.check.facts.OpenPorts;
import arcomat.check.law.Carrier;
import arcomat.check.law.Check;
import arcomat.check.law.Check.ComponentUse;
import arcomat.check.law.Check.Context;
import arcomat.check.walk.Listeners.Listener;
import arcomat.symbols.bodies.AutomatonSymbol;
import arcomat.symbols.bodies.ComponentSymbol;
import arcomat.symbols.bodies.ConnectorSymbol;
import arcomat.symbols.bodies.InstanceSymbol;
import arcomat.symbols.bodies.InvariantSymbol;
import arcomat.symbols.expressions.ParameterSymbol;
import arcomat.symbols.expressions.PortSymbol;
import arcomat.symbols.expressions.VariableSymbol;
import arcomat.symbols.signatures.ComponentReference;
import arcomat.tree.Component;
import arcomat.tree.Component.TypeParameter;
import arcomat.tree.Element;
import arcomat.tree.Node;
import arcomat.tree.QualifiedName;
import arcomat.tree.TypeReference;

import java.util.List;

/** The part of the walk that goes through components and their parts. */
record ComponentWalk(
        Listeners listeners,
        StereotypeWalk stereotypes,
        ExpressionWalk expressions,
        BehaviourWalk behaviours) {

    void component(ComponentSymbol component, Context around) {
        Context context = around.in(component);
        stereotypes.visit(component.stereotypes(), Carrier.COMPONENT, component.node(), context);
        for (Listener<Check.OnComponent> each : listeners.onComponent) {
            each.check().check(component, context, each.findings());
        }
        head(component, context);
        ElementWalk elements = new ElementWalk(stereotypes, expressions, context);
        component.node().elements().forEach(element -> element.accept(elements));
        members(component, context);
    }

    private void head(ComponentSymbol component, Context context) {
        Component node = component.node();
        for (TypeParameter parameter : node.typeParameters()) {
            for (TypeReference bound : parameter.bounds()) {
                expressions.type(bound, context);
            }
        }
        node.superComponent().ifPresent(type -> expressions.componentType(type, context));
        component
                .signature()
                .superComponent()
                .ifPresent(type -> use(type, node.superComponent().orElseThrow(), context));
        expressions.arguments(component.signature().superArguments(), context);
        for (QualifiedName refined : node.refines()) {
            expressions.name(refined);
        }
        node.instance().ifPresent(i -> expressions.typeArguments(i.arguments(), context));
        for (ParameterSymbol parameter : component.signature().ownParameters()) {
            expressions.type(parameter.node().type(), context);
            parameter
                    .initial()
                    .ifPresent(value -> expressions.value(value, parameter.type(), context));
        }
    }

    private void members(ComponentSymbol component, Context context) {
        for (PortSymbol port : component.signature().ownPorts()) {
            for (Listener<Check.OnPort> each : listeners.onPort) {
                each.check().check(port, context, each.findings());
            }
        }
        for (VariableSymbol variable : component.signature().ownVariables()) {
            expressions.variable(variable, context);
        }
        parts(component, context);
        for (ConnectorSymbol connector : Connections.own(component)) {
            for (Listener<Check.OnConnector> each : listeners.onConnector) {
                each.check().check(connector, context, each.findings());
            }
        }
        for (InvariantSymbol invariant : component.ownInvariants()) {
            invariant.condition().ifPresent(condition -> expressions.mentioned(condition, context));
        }
        for (AutomatonSymbol automaton : component.ownAutomata()) {
            behaviours.automaton(automaton, context);
        }
        for (ComponentSymbol inner : component.innerComponents()) {
            component(inner, context);
        }
    }

    private void parts(ComponentSymbol component, Context context) {
        if (component.ownInstances().isEmpty()) {
            return;
        }
        OpenPorts open = OpenPorts.in(component);
        Node last = null;
        for (InstanceSymbol part : component.ownInstances()) {
            List<PortSymbol> ports = open.of(part);
            for (Listener<Check.OnInstance> each : listeners.onInstance) {
                each.check().check(part, context, each.findings());
            }
            for (Listener<Check.OnOpenPorts> each : listeners.onOpenPorts) {
                each.check().check(part, ports, context, each.findings());
            }
            expressions.arguments(part.arguments(), context);
            if (part.node() != last) {
                use(part, context);
            }
            last = part.node();
        }
    }

    /** A declaration may make several parts of one type. */
    private void use(InstanceSymbol part, Context context) {
        if (part.node() instanceof Element.Subcomponent node) {
            use(part.type(), node.type(), context);
        } else if (part.node() instanceof Component inner && inner.instance().isPresent()) {
            Component.NamedInstance instance = inner.instance().get();
            QualifiedName name =
                    new QualifiedName(instance.name().span(), List.of(instance.name()));
            use(new ComponentUse(part.type(), name, instance.arguments()), context);
        }
    }

    private void use(ComponentReference reference, TypeReference written, Context context) {
        use(new ComponentUse(reference, written.name(), written.arguments()), context);
    }

    private void use(ComponentUse use, Context context) {
        for (Listener<Check.OnComponentUse> each : listeners.onComponentUse) {
            each.check().check(use, context, each.findings());
        }
    }
}
