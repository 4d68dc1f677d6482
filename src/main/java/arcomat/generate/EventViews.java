package arcomat.generate;

import arcomat.generate.view.EventPortView;
import arcomat.generate.view.EventView;
import arcomat.generate.view.HeadView;
import arcomat.generate.view.NetworkView;
import arcomat.generate.view.PartView;
import arcomat.generate.view.PortView;
import arcomat.model.Component;
import arcomat.model.Port;
import arcomat.semantics.network.Composition;
import arcomat.semantics.network.Source;

import java.util.ArrayList;
import java.util.List;
import java.util.function.Predicate;
import java.util.stream.IntStream;

/**
 * The views of event-driven components. A message is delivered when it is sent: the composite
 * overrides the sending method of each part by calls of the methods that take the message, so that
 * queues fill in the order that {@code semantics.Network} describes.
 */
final class EventViews {
    private final FileContext context;
    private final Program program;

    EventViews(FileContext context, Program program) {
        this.context = context;
        this.program = program;
    }

    EventView atomic(HeadView head) {
        Component component = context.component();
        Members members = context.members();
        return new EventView(
                head,
                new AtomicViews(context, program.choosing()).view(head, program.traced()),
                ports(context, component.inputs(), head.inputs()),
                ports(context, component.outputs(), head.outputs()),
                component.queueCapacity(),
                members.local("waiting", ""),
                members.local("oldest", ""),
                members.local("queued", ""),
                members.local("border", ""));
    }

    private static List<EventPortView> ports(
            FileContext context, List<Port> ports, List<PortView> heads) {
        List<EventPortView> views = new ArrayList<>();
        for (Port port : ports) {
            int number = views.size();
            boolean waits = port.isInput() && !port.latched();
            views.add(
                    new EventPortView(
                            heads.get(number),
                            context.members().method(port),
                            port.first()
                                    .map(v -> context.expressions().of(v, port.type()).text())
                                    .orElse(""),
                            waits ? context.members().local("waiting", port.name()) : "",
                            port.latched(),
                            number,
                            context.expressions().literal(port.name())));
        }
        return views;
    }

    /** A composite; a platform component is one without members. */
    NetworkView network(HeadView head) {
        Component component = context.component();
        List<NetworkView.RouteView> inputs = new ArrayList<>();
        List<EventPortView> ports = ports(context, component.inputs(), head.inputs());
        for (int i = 0; i < ports.size(); i++) {
            inputs.add(
                    new NetworkView.RouteView(
                            ports.get(i), receivers(-1, component.inputs().get(i))));
        }
        return new NetworkView(
                head,
                members(),
                inputs,
                ports(context, component.outputs(), head.outputs()),
                context.members().local("border", ""),
                context.expressions().checks());
    }

    private List<NetworkView.MemberView> members() {
        List<NetworkView.MemberView> members = new ArrayList<>();
        if (context.composition().isEmpty()) {
            return members;
        }
        for (Composition.Node node : context.composition().get().nodes()) {
            FileContext part = program.context(node.component());
            List<Port> outputs = node.component().outputs();
            List<EventPortView> ports =
                    ports(part, outputs, Heads.of(part, program.draws(node.component())).outputs());
            List<NetworkView.RouteView> routes = new ArrayList<>();
            for (int i = 0; i < outputs.size(); i++) {
                List<String> calls = receivers(members.size(), outputs.get(i));
                if (!calls.isEmpty()) {
                    routes.add(new NetworkView.RouteView(ports.get(i), calls));
                }
            }
            PartView view =
                    CompositeViews.part(
                            context, program, node, context.members().part(node.path()));
            members.add(new NetworkView.MemberView(view, !node.component().platform(), routes));
        }
        return members;
    }

    /**
     * The methods that take the messages of a port: of parts in order, then of the whole.
     *
     * @param sender position of the part, -1 for an input of the whole
     */
    private List<String> receivers(int sender, Port port) {
        List<String> calls = new ArrayList<>();
        if (context.composition().isEmpty()) {
            return calls;
        }
        Composition composition = context.composition().get();
        for (Composition.Node node : composition.nodes()) {
            List<Port> inputs = inputs(node, source -> isFrom(source, sender, port));
            deliver(context.members().part(node.path()), node.component(), inputs, calls);
        }
        for (Composition.Output output : composition.outputs()) {
            if (isFrom(output.source(), sender, port)) {
                calls.add(context.members().method(output.port()));
            }
        }
        return calls;
    }

    private static List<Port> inputs(Composition.Node node, Predicate<Source> isFed) {
        return IntStream.range(0, node.inputs().size())
                .filter(i -> isFed.test(node.inputs().get(i)))
                .mapToObj(node.component().inputs()::get)
                .toList();
    }

    /**
     * Where one message goes to several inputs of a composite, each of its parts takes it on all of
     * its own inputs before the next part does: how parts are grouped makes no difference.
     */
    private void deliver(String part, Component component, List<Port> inputs, List<String> calls) {
        FileContext inside = program.context(component);
        if (inputs.size() < 2 || inside.composition().isEmpty()) {
            inputs.forEach(input -> calls.add(part + "." + inside.members().method(input)));
            return;
        }
        for (Composition.Node node : inside.composition().get().nodes()) {
            List<Port> fed =
                    inputs(
                            node,
                            source ->
                                    source instanceof Source.FromOutside outside
                                            && inputs.contains(outside.port()));
            deliver(part + "." + inside.members().part(node.path()), node.component(), fed, calls);
        }
    }

    private static boolean isFrom(Source source, int sender, Port port) {
        if (source instanceof Source.FromNode from) {
            return from.node() == sender && from.port().name().equals(port.name());
        }
        return source instanceof Source.FromOutside outside
                && sender < 0
                && outside.port().name().equals(port.name());
    }
}
