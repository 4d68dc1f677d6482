package arcomat.lower;

import arcomat.model.Component;
import arcomat.model.Expression;
import arcomat.symbols.bodies.ConnectorSymbol;
import arcomat.symbols.bodies.InstanceSymbol;

import java.util.List;

/** The inside of a decomposed component: parts with all their arguments, single connections. */
record CompositionLowering(
        ComponentLowering components, Instantiation whole, Environment environment) {

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
        List<Expression> arguments =
                ArgumentLowering.lower(
                        instance.arguments(),
                        environment,
                        type.component().parameters(),
                        component.parameters(),
                        components.environment(type));
        return new Component.Part(instance.name(), component, arguments, instance.nameSpan());
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
