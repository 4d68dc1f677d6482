package arcomat.generate;

import arcomat.generate.language.Names;
import arcomat.generate.language.TypeName;
import arcomat.generate.view.AtomicView;
import arcomat.model.Component;
import arcomat.model.Port;
import arcomat.semantics.network.Composition;
import arcomat.semantics.network.Source;

import java.util.HashMap;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;

/** All components that are generated together, each known by its qualified name. */
final class Program {
    private static final String MEMBERS = "reserved.members";

    private final Names names;
    private final Choosing choosing;
    private final boolean traced;
    private final Map<String, FileContext> contexts = new LinkedHashMap<>();
    private final Map<String, Boolean> senses = new HashMap<>();
    private final Map<String, Boolean> draws = new HashMap<>();
    private final Map<String, Boolean> fails = new HashMap<>();
    private final Map<String, Arrangement> arrangements = new HashMap<>();

    Program(Names names, Choosing choosing, boolean traced, List<Component> roots) {
        this(names, choosing, traced, roots, List.of(MEMBERS));
    }

    private Program(
            Names names,
            Choosing choosing,
            boolean traced,
            List<Component> roots,
            List<String> reserved) {
        this.names = names;
        this.choosing = choosing;
        this.traced = traced;
        Map<String, Component> all = new LinkedHashMap<>();
        roots.forEach(root -> collect(root, all));
        all.values().forEach(names::of);
        for (Component component : all.values()) {
            contexts.put(
                    component.qualifiedName(),
                    FileContext.of(component, composition(component), names, reserved));
        }
    }

    /** Monitors, which inherit members. */
    static Program ofMonitors(Names names, List<Component> monitors) {
        List<String> reserved = List.of(MEMBERS, "reserved.monitor");
        return new Program(names, Choosing.FIRST, false, monitors, reserved);
    }

    /** Parts before what they are part of. */
    private static void collect(Component component, Map<String, Component> all) {
        if (all.containsKey(component.qualifiedName())) {
            return;
        }
        if (component.body() instanceof Component.Composite body && !component.platform()) {
            body.parts().forEach(part -> collect(part.component(), all));
        }
        all.put(component.qualifiedName(), component);
    }

    private static Optional<Composition> composition(Component component) {
        return component.isComposite() && !component.platform()
                ? Optional.of(Composition.of(component))
                : Optional.empty();
    }

    Names names() {
        return names;
    }

    Choosing choosing() {
        return choosing;
    }

    /** Whether components note which transition they took. */
    boolean traced() {
        return traced;
    }

    Iterable<FileContext> contexts() {
        return contexts.values();
    }

    FileContext context(Component component) {
        return contexts.get(component.qualifiedName());
    }

    Members members(Component component) {
        return context(component).members();
    }

    /** The class of a main program. */
    TypeName nameOfProgram(Component main) {
        return names.beside(main, "Program");
    }

    /** Whether a component has to sample something when a slice starts. */
    boolean senses(Component component) {
        Boolean known = senses.get(component.qualifiedName());
        if (known == null) {
            Optional<Composition> inside = context(component).composition();
            known =
                    component.platform()
                            ? !component.outputs().isEmpty()
                            : inside.isPresent()
                                    && inside.get().nodes().stream()
                                            .anyMatch(node -> senses(node.component()));
            senses.put(component.qualifiedName(), known);
        }
        return known;
    }

    /** Whether a message on the port of a node comes straight from a sensor. */
    boolean isSensed(Composition.Node node, Port port) {
        if (node.component().platform()) {
            return true;
        }
        if (node.inside().isEmpty()) {
            return false;
        }
        for (Composition.Output output : node.inside().get().outputs()) {
            if (output.port().name().equals(port.name())
                    && output.source() instanceof Source.FromNode from) {
                return isSensed(node.inside().get().nodes().get(from.node()), from.port());
            }
        }
        return false;
    }

    /** What a part does at its place in the schedule. */
    String call(Component component) {
        if (!component.platform()) {
            return "step";
        }
        return component.inputs().isEmpty() ? "" : "act";
    }

    /** Whether a component needs the generator of choices. */
    boolean draws(Component component) {
        Boolean known = draws.get(component.qualifiedName());
        if (known == null) {
            known = choosing == Choosing.RANDOM && drawsAnywhere(component);
            draws.put(component.qualifiedName(), known);
        }
        return known;
    }

    private boolean drawsAnywhere(Component component) {
        Optional<Composition> inside = context(component).composition();
        if (inside.isPresent()) {
            return inside.get().nodes().stream().anyMatch(node -> draws(node.component()));
        }
        return Members.automaton(component).isPresent()
                && new AtomicViews(context(component), choosing).draws();
    }

    /** Whether a step, or the construction, may end in an error of the model. */
    boolean fails(Component component) {
        Boolean known = fails.get(component.qualifiedName());
        if (known == null) {
            known = failsAnywhere(context(component));
            fails.put(component.qualifiedName(), known);
        }
        return known;
    }

    private boolean failsAnywhere(FileContext context) {
        if (context.composition().isPresent()) {
            List<Composition.Node> nodes = context.composition().get().nodes();
            nodes.forEach(n -> n.arguments().forEach(a -> context.expressions().of(a)));
            return context.expressions().checks()
                    || nodes.stream().anyMatch(node -> fails(node.component()));
        }
        Component component = context.component();
        if (Members.automaton(component).isEmpty()) {
            return false;
        }
        AtomicView view =
                new AtomicViews(context, choosing)
                        .view(Heads.of(context, draws(component)), traced);
        return view.checks()
                || view.sections().stream()
                        .flatMap(section -> section.states().stream())
                        .anyMatch(state -> !state.error().isEmpty());
    }

    /** How the parts of a composite are ordered and held. */
    Arrangement arrangement(FileContext context) {
        String name = context.component().qualifiedName();
        Arrangement known = arrangements.get(name);
        if (known == null) {
            known = Arrangement.of(context, this);
            arrangements.put(name, known);
        }
        return known;
    }
}
