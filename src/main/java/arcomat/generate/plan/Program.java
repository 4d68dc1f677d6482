package arcomat.generate.plan;

import arcomat.generate.language.TargetNames;
import arcomat.generate.language.TypeName;
import arcomat.generate.text.FileContext;
import arcomat.generate.text.MemberNames;
import arcomat.model.Component;
import arcomat.model.Port;
import arcomat.semantics.network.Composition;
import arcomat.semantics.network.Source;

import java.util.HashMap;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.Optional;
import java.util.function.Predicate;
import java.util.function.Supplier;

/** All components that are generated together, each known by its qualified name. */
public final class Program {
    private static final String MEMBERS = "reserved.members";

    private final TargetNames names;
    private final Choosing choosing;
    private final boolean traced;
    private final Map<String, FileContext> contexts = new LinkedHashMap<>();
    private final Answers<Boolean> senses = new Answers<>();
    private final Answers<Boolean> fails = new Answers<>();
    private final Answers<Boolean> draws = new Answers<>();
    private final Answers<AutomatonPlan> automata = new Answers<>();
    private final Answers<Arrangement> arrangements = new Answers<>();

    /**
     * What was found out about components; the answer about a whole asks for those of its parts.
     */
    private static final class Answers<T> {
        private final Map<String, T> known = new HashMap<>();

        T of(Component component, Supplier<T> answer) {
            String name = component.qualifiedName();
            if (!known.containsKey(name)) {
                known.put(name, answer.get());
            }
            return Objects.requireNonNull(known.get(name));
        }
    }

    private Program(
            TargetNames names,
            Choosing choosing,
            boolean traced,
            List<Component> roots,
            String... reserved) {
        this.names = names;
        this.choosing = choosing;
        this.traced = traced;
        Map<String, Component> all = new LinkedHashMap<>();
        roots.forEach(root -> collect(root, all));
        all.values().forEach(names::of);
        all.forEach(
                (name, each) ->
                        contexts.put(
                                name, FileContext.of(each, composition(each), names, reserved)));
    }

    /**
     * Components with all that they are made of.
     *
     * @param traced whether components note which transition they took
     */
    public static Program of(
            TargetNames names, Choosing choosing, boolean traced, List<Component> roots) {
        return new Program(names, choosing, traced, roots, MEMBERS);
    }

    /** Monitors, which inherit members. */
    public static Program ofMonitors(TargetNames names, List<Component> monitors) {
        return new Program(names, Choosing.FIRST, false, monitors, MEMBERS, "reserved.monitor");
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

    public TargetNames names() {
        return names;
    }

    /** Whether components note which transition they took. */
    public boolean traced() {
        return traced;
    }

    public Iterable<FileContext> contexts() {
        return contexts.values();
    }

    public FileContext context(Component component) {
        return Objects.requireNonNull(contexts.get(component.qualifiedName()));
    }

    public MemberNames members(Component component) {
        return context(component).members();
    }

    /** The class of a main program. */
    public TypeName nameOfProgram(Component main) {
        return names.beside(main, "Program");
    }

    private boolean anyNode(Component component, Predicate<Component> asked) {
        return context(component).composition().stream()
                .flatMap(inside -> inside.nodes().stream())
                .anyMatch(node -> asked.test(node.component()));
    }

    /** Whether a component has to sample something when a slice starts. */
    public boolean senses(Component component) {
        return senses.of(
                component,
                () ->
                        component.platform()
                                ? !component.outputs().isEmpty()
                                : anyNode(component, this::senses));
    }

    /** Whether a message on the port of a node comes straight from a sensor. */
    public boolean isSensed(Composition.Node node, Port port) {
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
    public String call(Component component) {
        if (!component.platform()) {
            return "step";
        }
        return component.inputs().isEmpty() ? "" : "act";
    }

    /** What the code of a component decides that has an automaton; none for others. */
    public Optional<AutomatonPlan> automaton(Component component) {
        return MemberNames.automaton(component)
                .map(
                        automaton ->
                                automata.of(
                                        component,
                                        () ->
                                                AutomatonPlan.of(
                                                        context(component),
                                                        automaton,
                                                        choosing,
                                                        traced)));
    }

    /** Whether a component needs the generator of choices. */
    public boolean draws(Component component) {
        return choosing == Choosing.RANDOM
                && draws.of(
                        component,
                        () ->
                                automaton(component).filter(AutomatonPlan::draws).isPresent()
                                        || anyNode(component, this::draws));
    }

    /** Whether a step, or the construction, may end in an error of the model. */
    boolean fails(Component component) {
        return fails.of(
                component,
                () ->
                        automaton(component).filter(AutomatonPlan::mayFail).isPresent()
                                || context(component).composition().stream()
                                        .flatMap(inside -> inside.nodes().stream())
                                        .anyMatch(Arrangement::checks)
                                || anyNode(component, this::fails));
    }

    /** How the parts of a composite are ordered and held. */
    public Arrangement arrangement(FileContext context) {
        return arrangements.of(context.component(), () -> Arrangement.of(context, this));
    }
}
