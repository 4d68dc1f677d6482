package arcomat.lower;

import arcomat.model.Component;
import arcomat.model.Invariant;
import arcomat.model.Port;
import arcomat.model.Type;
import arcomat.model.Variable;
import arcomat.symbols.bodies.ComponentSymbol;
import arcomat.symbols.bodies.InvariantSymbol;

import java.util.ArrayList;
import java.util.List;

/** The invariants that have a meaning. */
final class InvariantLowering {
    private InvariantLowering() {}

    /**
     * @param body of the component, lowered
     * @param environment what its automata may read: ports, parameters, constants
     */
    static List<Invariant> lower(
            ComponentSymbol component, Component.Body body, Environment environment) {
        List<InvariantSymbol> symbols =
                component.invariants().stream().filter(i -> i.condition().isPresent()).toList();
        if (symbols.isEmpty()) {
            return List.of();
        }
        ExpressionLowering expressions =
                new ExpressionLowering(
                        environment.withVariables(variables(body)).withPorts(sentByParts(body)));
        return symbols.stream()
                .map(
                        symbol ->
                                new Invariant(
                                        symbol.title(),
                                        expressions.lower(
                                                symbol.condition().orElseThrow(),
                                                new Type.BooleanType()),
                                        symbol.nameSpan()))
                .toList();
    }

    private static List<Variable> variables(Component.Body body) {
        return body instanceof Component.Atomic atomic
                ? atomic.automata().stream().flatMap(each -> each.variables().stream()).toList()
                : List.of();
    }

    private static List<Port> sentByParts(Component.Body body) {
        List<Port> ports = new ArrayList<>();
        if (body instanceof Component.Composite composite) {
            for (Component.Part part : composite.parts()) {
                for (Port port : part.component().outputs()) {
                    ports.add(port.named(part.name() + "." + port.name()));
                }
            }
        }
        return ports;
    }
}
