package arcomat.check;

import arcomat.check.Listeners.Listener;
import arcomat.symbols.Workspace;
import arcomat.tree.Automaton;
import arcomat.tree.Behaviour;
import arcomat.tree.ClassDiagram;
import arcomat.tree.Component;
import arcomat.tree.Definition;
import arcomat.tree.Element;
import arcomat.tree.IoTable;
import arcomat.tree.Node;
import arcomat.tree.Parameter;
import arcomat.tree.Stereotype;
import arcomat.tree.TestSuite;
import arcomat.tree.TypeParameter;
import arcomat.tree.TypeReference;
import arcomat.tree.Unit;
import arcomat.tree.Variable;

import java.util.List;

/** The one walk over a workspace, in text order: files, components and what stands in them. */
final class Walk {
    private final Listeners listeners;
    private final ExpressionWalk expressions;
    private final BehaviourWalk behaviours;

    Walk(Listeners listeners, Suppressions suppressions) {
        this.listeners = listeners;
        this.expressions = new ExpressionWalk(listeners);
        this.behaviours = new BehaviourWalk(listeners, suppressions, expressions);
    }

    void walk(Workspace workspace) {
        for (Listener<Check.OnWorkspace> each : listeners.onWorkspace) {
            each.check().check(workspace, each.findings());
        }
        for (Unit unit : workspace.units()) {
            Context context = Context.of(workspace, unit);
            for (Listener<Check.OnUnit> each : listeners.onUnit) {
                each.check().check(unit, context, each.findings());
            }
            definition(unit.definition(), context);
        }
    }

    private void definition(Definition definition, Context context) {
        if (definition instanceof Component component) {
            component(component, context);
        } else if (definition instanceof Automaton automaton) {
            behaviours.automaton(automaton, context);
        } else if (definition instanceof ClassDiagram diagram) {
            classDiagram(diagram, context);
        } else if (definition instanceof TestSuite suite) {
            testSuite(suite, context);
        } else {
            throw new AssertionError(definition);
        }
    }

    private void component(Component component, Context around) {
        Context context = around.in(component);
        stereotypes(component.stereotypes(), Carrier.COMPONENT, component, context);
        for (Listener<Check.OnComponent> each : listeners.onComponent) {
            each.check().check(component, context, each.findings());
        }
        for (TypeParameter parameter : component.typeParameters()) {
            types(parameter.bounds(), context);
        }
        for (Parameter parameter : component.parameters()) {
            expressions.type(parameter.type(), context);
            expressions.optional(parameter.initial(), context);
        }
        component.superComponent().ifPresent(type -> expressions.type(type, context));
        component
                .instance()
                .ifPresent(i -> expressions.typeArguments(i.arguments(), context));
        for (Element element : component.elements()) {
            element(element, context);
        }
    }

    private void element(Element element, Context context) {
        if (element instanceof Component inner) {
            component(inner, context);
        } else if (element instanceof Behaviour behaviour) {
            behaviour(behaviour, context);
        } else if (element instanceof Element.Ports ports) {
            ports(ports, context);
        } else if (element instanceof Element.Subcomponent subcomponent) {
            subcomponent(subcomponent, context);
        } else if (element instanceof Element.Connector connector) {
            stereotypes(connector.stereotypes(), Carrier.CONNECTOR, connector, context);
        } else if (element instanceof Element.Variables variables) {
            variables(variables.type(), variables.variables(), context);
        } else if (element instanceof Element.Timing timing) {
            stereotypes(timing.stereotypes(), Carrier.TIMING, timing, context);
        } else if (element instanceof Element.Autoconnect clause) {
            stereotypes(clause.stereotypes(), Carrier.AUTOCONNECT, clause, context);
        } else if (element instanceof Element.Autoinstantiate clause) {
            stereotypes(clause.stereotypes(), Carrier.AUTOINSTANTIATE, clause, context);
        }
    }

    private void behaviour(Behaviour behaviour, Context context) {
        if (behaviour instanceof Automaton automaton) {
            behaviours.automaton(automaton, context);
        } else if (behaviour instanceof IoTable table) {
            behaviours.table(table, context);
        } else if (behaviour instanceof Behaviour.Implementation implementation) {
            for (Automaton automaton : implementation.automata()) {
                behaviours.automaton(automaton, context);
            }
        } else {
            throw new AssertionError(behaviour);
        }
    }

    private void ports(Element.Ports ports, Context context) {
        stereotypes(ports.stereotypes(), Carrier.PORT, ports, context);
        for (Element.Port port : ports.ports()) {
            stereotypes(port.stereotypes(), Carrier.PORT, port, context);
            for (Listener<Check.OnPort> each : listeners.onPort) {
                each.check().check(port, context, each.findings());
            }
            expressions.type(port.type(), context);
        }
    }

    private void subcomponent(Element.Subcomponent subcomponent, Context context) {
        stereotypes(subcomponent.stereotypes(), Carrier.SUBCOMPONENT, subcomponent, context);
        for (Listener<Check.OnSubcomponent> each : listeners.onSubcomponent) {
            each.check().check(subcomponent, context, each.findings());
        }
        expressions.type(subcomponent.type(), context);
        expressions.all(subcomponent.arguments(), context);
        for (Element.Instance instance : subcomponent.instances()) {
            for (Element.SimpleConnector connector : instance.connectors()) {
                stereotypes(connector.stereotypes(), Carrier.CONNECTOR, connector, context);
            }
        }
    }

    private void variables(TypeReference type, List<Variable> variables, Context context) {
        expressions.type(type, context);
        for (Variable variable : variables) {
            expressions.variable(variable, type, context);
        }
    }

    private void classDiagram(ClassDiagram diagram, Context context) {
        for (Listener<Check.OnClassDiagram> each : listeners.onClassDiagram) {
            each.check().check(diagram, context, each.findings());
        }
        for (ClassDiagram.TypeDefinition type : diagram.types()) {
            if (type instanceof ClassDiagram.ClassDefinition definition) {
                definition.superClass().ifPresent(t -> expressions.type(t, context));
                for (ClassDiagram.Attribute attribute : definition.attributes()) {
                    expressions.type(attribute.type(), context);
                }
            }
        }
    }

    private void testSuite(TestSuite suite, Context context) {
        for (Listener<Check.OnTestSuite> each : listeners.onTestSuite) {
            each.check().check(suite, context, each.findings());
        }
        expressions.all(suite.arguments(), context);
        for (TestSuite.Member member : suite.members()) {
            if (member instanceof TestSuite.Field field) {
                variables(field.type(), field.variables(), context);
            } else if (member instanceof TestSuite.Test test) {
                for (TestSuite.Streams streams : test.streams()) {
                    for (TestSuite.PortStream stream : streams.streams()) {
                        expressions.stream(stream.elements(), context);
                    }
                }
            }
        }
    }

    private void types(List<TypeReference> types, Context context) {
        for (TypeReference type : types) {
            expressions.type(type, context);
        }
    }

    private void stereotypes(
            List<Stereotype> stereotypes, Carrier carrier, Node owner, Context context) {
        behaviours.stereotypes(stereotypes, carrier, owner, context);
    }
}
