package arcomat.lower;

import arcomat.model.Component;
import arcomat.model.Expression;
import arcomat.symbols.bodies.ConnectorSymbol;
import arcomat.symbols.bodies.InstanceSymbol;
import arcomat.symbols.expressions.Typed;

import java.util.ArrayList;
import java.util.List;

/** The inside of a decomposed component: parts with all their arguments, single connections. */
final class CompositionLowering {
    private final ComponentLowering components;
    private final Instantiation whole;
    private final Environment environment;

    CompositionLowering(
            ComponentLowering components, Instantiation whole, Environment environment) {
        this.components = components;
        this.whole = whole;
        this.environment = environment;
    }

    Component.Composite lower() {
        List<Component.Part> parts =
                whole.component().instances().stream().map(this::part).toList();
        List<Component.Connection> connections =
                whole.component().connectors().stream()
                        .map(CompositionLowering::connection)
                        .toList();
        return new Component.Composite(parts, connections);
    }

    private Component.Part part(InstanceSymbol instance) {
        Instantiation type = whole.of(instance);
        Component component = components.lowered(type);
        List<Expression> given = new ArrayList<>();
        ExpressionLowering expressions = new ExpressionLowering(environment);
        for (int i = 0; i < instance.arguments().size(); i++) {
            Typed argument = instance.arguments().get(i);
            given.add(expressions.lower(argument, component.parameters().get(i).type()));
        }
        List<Expression> all =
                Arguments.complete(
                        given,
                        type.component().parameters(),
                        component.parameters(),
                        components.environment(type));
        return new Component.Part(instance.name(), component, all, instance.nameSpan());
    }

    private static Component.Connection connection(ConnectorSymbol connector) {
        return new Component.Connection(
                endpoint(connector.source()), endpoint(connector.target()), connector.span());
    }

    private static Component.Endpoint endpoint(ConnectorSymbol.End end) {
        return new Component.Endpoint(
                end.instance().map(InstanceSymbol::name), end.port().orElseThrow().name());
    }
}
