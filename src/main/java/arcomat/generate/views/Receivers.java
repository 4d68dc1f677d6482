package arcomat.generate.views;

import arcomat.generate.plan.Arrangement;
import arcomat.generate.plan.Program;
import arcomat.generate.plan.Sections;
import arcomat.generate.text.FileContext;
import arcomat.model.Component;
import arcomat.model.Port;
import arcomat.semantics.network.Composition;
import arcomat.semantics.network.Source;

import org.jspecify.annotations.Nullable;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;

/** The methods that take the messages of a port within one event-driven composite. */
final class Receivers {
    /** Who sends what comes in from outside. */
    static final int OUTSIDE = -1;

    private final FileContext context;
    private final Program program;
    private final String whole;
    private final Map<Sender, Map<Integer, List<Port>>> inputs = new HashMap<>();
    private final Map<Sender, List<Port>> outputs = new HashMap<>();

    /**
     * @param node position of the part, {@link #OUTSIDE} for an input of the whole
     */
    private record Sender(int node, String port) {}

    /**
     * @param whole the field by which a section knows the composite
     */
    Receivers(FileContext context, Program program, String whole) {
        this.context = context;
        this.program = program;
        this.whole = whole;
        context.composition().ifPresent(this::note);
    }

    private void note(Composition composition) {
        List<Composition.Node> nodes = composition.nodes();
        for (int i = 0; i < nodes.size(); i++) {
            int receiver = i;
            for (int k = 0; k < nodes.get(i).inputs().size(); k++) {
                Port port = nodes.get(i).component().inputs().get(k);
                Sender sender = sender(nodes.get(i).inputs().get(k));
                if (sender != null) {
                    inputs.computeIfAbsent(sender, s -> new LinkedHashMap<>())
                            .computeIfAbsent(receiver, r -> new ArrayList<>())
                            .add(port);
                }
            }
        }
        for (Composition.Output output : composition.outputs()) {
            Sender sender = sender(output.source());
            if (sender != null) {
                outputs.computeIfAbsent(sender, s -> new ArrayList<>()).add(output.port());
            }
        }
    }

    private static @Nullable Sender sender(Source source) {
        return source.match(
                outside -> new Sender(OUTSIDE, outside.port().name()),
                from -> new Sender(from.node(), from.port().name()),
                () -> null);
    }

    /**
     * Of parts in order, then of the whole.
     *
     * @param node position of the part that sends
     * @param here the section that makes the calls; null where the composite does
     */
    List<String> of(int node, Port port, Sections.@Nullable Section here) {
        Sender sender = new Sender(node, port.name());
        List<String> calls = new ArrayList<>();
        inputs.getOrDefault(sender, Map.of())
                .forEach((receiver, fed) -> deliver(context, receiver, here, "", fed, calls));
        String outside = here == null ? "" : whole + ".";
        for (Port output : outputs.getOrDefault(sender, List.of())) {
            calls.add(outside + context.members().method(output));
        }
        return calls;
    }

    /**
     * Where one message goes to several inputs of a composite, each of its parts takes it on all of
     * its own inputs before the next part does: how parts are grouped makes no difference.
     */
    private void deliver(
            FileContext outer,
            int receiver,
            Sections.@Nullable Section here,
            String above,
            List<Port> fed,
            List<String> calls) {
        Arrangement arrangement = program.arrangement(outer);
        Component component = arrangement.composition().nodes().get(receiver).component();
        FileContext inside = program.context(component);
        String part = above + arrangement.object(receiver, here, whole) + ".";
        if (fed.size() < 2 || inside.composition().isEmpty()) {
            fed.forEach(input -> calls.add(part + inside.members().method(input)));
            return;
        }
        List<Composition.Node> nodes = inside.composition().get().nodes();
        for (int i = 0; i < nodes.size(); i++) {
            List<Port> inner = inputs(nodes.get(i), fed);
            if (!inner.isEmpty()) {
                deliver(inside, i, null, part, inner, calls);
            }
        }
    }

    /** Inputs of a part that get the messages of some inputs of the composite around it. */
    private static List<Port> inputs(Composition.Node node, List<Port> outer) {
        List<Port> inner = new ArrayList<>();
        for (int i = 0; i < node.inputs().size(); i++) {
            if (node.inputs().get(i) instanceof Source.FromOutside outside
                    && outer.contains(outside.port())) {
                inner.add(node.component().inputs().get(i));
            }
        }
        return inner;
    }
}
