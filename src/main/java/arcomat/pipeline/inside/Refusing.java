package arcomat.pipeline.inside;

import arcomat.generate.CodeLayout;
import arcomat.model.Automaton;
import arcomat.model.Component;
import arcomat.model.Refusal;
import arcomat.pipeline.compile.AutomatonFields;
import arcomat.pipeline.compile.CodeParts;
import arcomat.semantics.automaton.ComponentSemantics;
import arcomat.semantics.automaton.Configuration;
import arcomat.semantics.automaton.Input;
import arcomat.semantics.automaton.StepRelation;
import arcomat.semantics.automaton.WhyNot;
import arcomat.semantics.network.Network;
import arcomat.sim.load.LoadedProgram;
import arcomat.sim.load.Probe;
import arcomat.simulate.run.RobotRun;

import java.util.ArrayList;
import java.util.IdentityHashMap;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.Optional;

/**
 * What the parts of one robot's program do while it runs, and why no transition of theirs is
 * enabled: at the beginning of each of their steps the fields of the generated code say where they
 * are, and the model says what that means. Events are handled one by one, and a step is that of one
 * event. A part has one automaton, since no code is made of several (ARC0126).
 */
public final class Refusing {
    private final CodeLayout layout;
    private final Component whole;

    /** Where the objects of the program are there. */
    private final Probe first;

    /** Where a cycle begins. */
    private final Probe turn;

    /** The method in which a part takes a step. */
    private final String step;

    private final List<Network.Instance> instances;
    private final ProgramTrace trace;
    private final Map<Object, Part> parts = new IdentityHashMap<>();

    /** A part as it runs. */
    private record Part(
            Network.Instance instance,
            StepRelation relation,
            WhyNot whyNot,
            AutomatonFields fields) {
        Optional<Refusal> nearest(Configuration configuration, Input input) {
            return relation.choices(configuration, input).enabled().isEmpty()
                    ? whyNot.nearest(configuration, input)
                    : Optional.empty();
        }
    }

    /**
     * What is to be said of a step.
     *
     * @param part its path in the program; empty for the whole
     * @param nearest the transition that came nearest, where none was enabled and one leaves the
     *     state
     */
    public record Said(String part, Optional<Refusal> nearest) {}

    private Refusing(CodeLayout layout, Component whole) {
        this.layout = layout;
        this.whole = whole;
        String type = place(layout, whole).className();
        if (whole.profile() == Component.Profile.EVENT_DRIVEN) {
            String program = Objects.requireNonNull(layout.programs().get(whole.qualifiedName()));
            first = new Probe(type, "start");
            turn = new Probe(program, "slice");
            step = "handle";
        } else {
            first = new Probe(type, "step");
            turn = first;
            step = first.method();
        }
        Network network = Network.of(whole, List.of());
        this.trace = new ProgramTrace(whole, network);
        this.instances =
                network.instances().stream()
                        .filter(each -> automaton(each.component()).isPresent())
                        .toList();
    }

    /** Of a program; nothing where it was not made of a model. */
    public static Optional<Refusing> of(Optional<CodeLayout> layout) {
        return layout.filter(each -> each.wholes().size() == 1)
                .map(each -> new Refusing(each, each.wholes().get(0)));
    }

    private static CodeLayout.Place place(CodeLayout layout, Component component) {
        return Objects.requireNonNull(layout.components().get(component.qualifiedName()));
    }

    private static Optional<Automaton> automaton(Component component) {
        return component.platform()
                        || !(component.body() instanceof Component.Atomic body)
                        || body.automata().size() != 1
                ? Optional.empty()
                : Optional.of(body.automata().get(0));
    }

    /** The same program, which tells when its parts take their steps. */
    public LoadedProgram probed(LoadedProgram program) {
        List<Probe> probes = new ArrayList<>(List.of(first, turn));
        instances.forEach(
                each -> probes.add(new Probe(place(layout, each.component()).className(), step)));
        return LoadedProgram.forMany(
                program.program(), probes.stream().distinct().toList(), List.of());
    }

    /**
     * A step begins; nothing where it is not that of a part with an automaton.
     *
     * @param time in milliseconds
     */
    public Optional<Said> entered(long time, Object object, String method) {
        if (isAt(first, object, method) && parts.isEmpty()) {
            meet(object);
        }
        if (isAt(turn, object, method)) {
            trace.begin(time);
        }
        return method.equals(step)
                ? Optional.ofNullable(parts.get(object)).map(this::step)
                : Optional.empty();
    }

    private static boolean isAt(Probe probe, Object object, String method) {
        return probe.method().equals(method) && object.getClass().getName().equals(probe.type());
    }

    private Said step(Part part) {
        Configuration before = part.fields().configuration();
        Input input = part.fields().input();
        Optional<Refusal> nearest = part.nearest(before, input);
        trace.step(part.instance(), part.relation(), before, input, nearest);
        return new Said(part.instance().path(), nearest);
    }

    /** What the program has done so far. */
    public RobotRun run(String robot) {
        return trace.run(robot);
    }

    private void meet(Object object) {
        Map<String, CodeParts.Part> objects = CodeParts.of(whole, object, layout);
        for (Network.Instance each : instances) {
            Object own = Objects.requireNonNull(objects.get(each.path())).object();
            StepRelation relation =
                    ComponentSemantics.of(each.component(), each.arguments()).relations().get(0);
            trace.start(each, relation);
            parts.put(
                    own,
                    new Part(
                            each,
                            relation,
                            WhyNot.of(relation),
                            new AutomatonFields(
                                    each.component(), relation.automaton(), own, layout)));
        }
    }
}
