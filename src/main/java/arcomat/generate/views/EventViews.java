package arcomat.generate.views;

import arcomat.generate.plan.Arrangement;
import arcomat.generate.plan.AutomatonPlan;
import arcomat.generate.plan.Program;
import arcomat.generate.text.FileContext;
import arcomat.generate.text.MemberNames;
import arcomat.generate.view.EventView;
import arcomat.generate.view.EventView.EventPortView;
import arcomat.generate.view.HeadView;
import arcomat.generate.view.HeadView.PortView;
import arcomat.generate.view.NetworkView;
import arcomat.model.Component;
import arcomat.model.Port;
import arcomat.semantics.network.Composition;
import arcomat.semantics.network.Source;

import java.util.ArrayList;
import java.util.List;
import java.util.function.Predicate;
import java.util.stream.IntStream;
import java.util.stream.Stream;

/**
 * The views of event-driven components. A message is delivered when it is sent: the composite
 * overrides the sending method of each part by calls of the methods that take the message, so that
 * queues fill in the order that {@code semantics.Network} describes.
 */
public final class EventViews {
    private final FileContext context;
    private final Program program;
    private final HeadView head;
    private final List<EventPortView> inputs;
    private final List<EventPortView> outputs;
    private final List<Composition.Node> nodes;

    public EventViews(FileContext context, Program program, HeadView head) {
        this.context = context;
        this.program = program;
        this.head = head;
        this.inputs = ports(context, context.component().inputs(), head.inputs());
        this.outputs = ports(context, context.component().outputs(), head.outputs());
        this.nodes = context.composition().map(Composition::nodes).orElse(List.of());
    }

    public EventView atomic(AutomatonPlan plan) {
        MemberNames members = context.members();
        return new EventView(
                head,
                new AtomicViews(context, plan, program.traced()).view(head),
                inputs,
                outputs,
                context.component().queueCapacity(),
                members.local("waiting"),
                members.local("oldest"),
                members.local("queued"),
                members.local("border"));
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
    public NetworkView network() {
        return new NetworkView(
                head,
                members(),
                routes(-1, context.component().inputs(), inputs).toList(),
                outputs,
                context.members().local("border"),
                nodes.stream().anyMatch(Arrangement::checks));
    }

    private List<NetworkView.MemberView> members() {
        List<NetworkView.MemberView> members = new ArrayList<>();
        for (Composition.Node node : nodes) {
            FileContext part = program.context(node.component());
            List<Port> sending = node.component().outputs();
            List<PortView> heads = Heads.of(node.component(), program).outputs();
            members.add(
                    new NetworkView.MemberView(
                            CompositeViews.part(context, program, node),
                            !node.component().platform(),
                            routes(members.size(), sending, ports(part, sending, heads))
                                    .filter(route -> !route.calls().isEmpty())
                                    .toList()));
        }
        return members;
    }

    private Stream<NetworkView.RouteView> routes(
            int sender, List<Port> ports, List<EventPortView> views) {
        return IntStream.range(0, ports.size())
                .mapToObj(
                        i ->
                                new NetworkView.RouteView(
                                        views.get(i), receivers(sender, ports.get(i))));
    }

    /**
     * The methods that take the messages of a port: of parts in order, then of the whole.
     *
     * @param sender position of the part, -1 for an input of the whole
     */
    private List<String> receivers(int sender, Port port) {
        List<String> calls = new ArrayList<>();
        for (Composition.Node node : nodes) {
            List<Port> fed = inputs(node, source -> isFrom(source, sender, port));
            deliver(context.members().part(node), node.component(), fed, calls);
        }
        context.composition().stream()
                .flatMap(inside -> inside.outputs().stream())
                .filter(output -> isFrom(output.source(), sender, port))
                .forEach(output -> calls.add(context.members().method(output.port())));
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
            deliver(part + "." + inside.members().part(node), node.component(), fed, calls);
        }
    }

    private static boolean isFrom(Source source, int sender, Port port) {
        String name = port.name();
        return source.match(
                outside -> sender < 0 && outside.port().name().equals(name),
                from -> from.node() == sender && from.port().name().equals(name),
                () -> false);
    }
}
