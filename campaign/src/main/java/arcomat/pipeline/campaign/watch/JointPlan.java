package arcomat.pipeline.campaign.watch;

import arcomat.campaign.Campaign;
import arcomat.campaign.JointWatch;
import arcomat.campaign.JointWatch.Binding;
import arcomat.generate.CodeLayout;
import arcomat.generate.GeneratedFile;
import arcomat.generate.Generation;
import arcomat.generate.Monitors;
import arcomat.generate.Target;
import arcomat.model.Component;
import arcomat.model.Parameter;
import arcomat.model.Port;
import arcomat.pipeline.WrongUse;
import arcomat.pipeline.campaign.joint.FieldValue;
import arcomat.pipeline.campaign.joint.JointFreight;
import arcomat.pipeline.campaign.joint.JointRequirement;
import arcomat.pipeline.campaign.joint.JointRequirement.WatchedPort;
import arcomat.pipeline.campaign.measure.Vocabulary;
import arcomat.pipeline.compile.ClassFiles;
import arcomat.pipeline.compile.Compilation;
import arcomat.pipeline.compile.MemoryCompiler;
import arcomat.pipeline.compile.OversizedCode;
import arcomat.pipeline.generate.Watches;
import arcomat.semantics.Promise;
import arcomat.source.Diagnostic;
import arcomat.source.Nearest;
import arcomat.source.SourceFile;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.Optional;
import java.util.TreeMap;

/** Finds what a campaign watches several robots for, and makes the monitors. */
final class JointPlan {
    private final List<WatchedRoot> roots;
    private final JointBindings bindings;
    private final Map<String, byte[]> classes = new TreeMap<>();
    private final List<JointRequirement> requirements = new ArrayList<>();
    private final List<Diagnostic> findings = new ArrayList<>();

    private JointPlan(List<WatchedRoot> roots, JointBindings bindings) {
        this.roots = roots;
        this.bindings = bindings;
    }

    /** What came of it; nothing of it is used where there are findings. */
    record Result(JointFreight freight, List<Diagnostic> findings) {}

    /**
     * @param code the programs as they will run
     * @param world text of the world
     */
    static Result of(
            Campaign campaign, CampaignCode code, List<WatchedRoot> roots, SourceFile world) {
        JointBindings bindings = new JointBindings(code, roots, Vocabulary.of(campaign, world));
        JointPlan plan = new JointPlan(roots, bindings);
        campaign.jointWatches().forEach(plan::add);
        return new Result(
                new JointFreight(plan.classes, plan.requirements, bindings.programs()),
                plan.findings);
    }

    private void add(JointWatch watch) {
        try {
            Promise promise = promise(watch);
            List<Diagnostic> wrong = wrong(watch, promise.component());
            findings.addAll(wrong);
            if (wrong.isEmpty()) {
                make(watch, promise);
            }
        } catch (WrongUse e) {
            findings.add(error(watch, String.valueOf(e.getMessage())));
        }
    }

    private static Diagnostic error(JointWatch watch, String message) {
        return Diagnostic.error(WatchFreight.NOT_WATCHED, watch.place(), message);
    }

    /** The requirement, of the first model root that has it. */
    private Promise promise(JointWatch watch) throws WrongUse {
        Optional<WrongUse> why = Optional.empty();
        for (WatchedRoot root : roots) {
            try {
                Promise promise = Watches.promise(watch.requirement(), root.models());
                requireSlices(promise.component());
                return promise;
            } catch (WrongUse e) {
                why = why.or(() -> Optional.of(e));
            }
        }
        throw why.orElseGet(
                () ->
                        new WrongUse(
                                "no robot's program is made of a component, so there are no models"
                                        + " that have a requirement"));
    }

    private static void requireSlices(Component required) throws WrongUse {
        if (required.profile() != Component.Profile.TIME_SYNCHRONOUS) {
            throw new WrongUse(
                    "'%s' handles events; several robots can be watched only for what works slice"
                            + " by slice",
                    required.qualifiedName());
        }
    }

    /** What is wrong with bindings, and which ports have none. */
    private List<Diagnostic> wrong(JointWatch watch, Component required) {
        List<Diagnostic> wrong = new ArrayList<>();
        Map<String, Port> open = new LinkedHashMap<>();
        required.ports().forEach(port -> open.put(port.name(), port));
        List<String> names = List.copyOf(open.keySet());
        for (Binding each : watch.bindings()) {
            Port port = open.remove(each.port());
            if (port == null) {
                wrong.add(
                        Diagnostic.error(
                                WatchFreight.NOT_WATCHED,
                                each.place(),
                                "'%s' has no port '%s'%s"
                                        .formatted(
                                                required.qualifiedName(),
                                                each.port(),
                                                Nearest.hint(each.port(), names))));
            } else {
                wrong.addAll(bindings.bind(port, each));
            }
        }
        for (String name : open.keySet()) {
            String message = "nothing says what port '%s' of '%s' shows: write a line '%s = WHAT'";
            wrong.add(error(watch, message.formatted(name, required.qualifiedName(), name)));
        }
        return wrong;
    }

    private void make(JointWatch watch, Promise promise) {
        Generation generation =
                Monitors.generate(
                        promise.component(),
                        promise.automata(),
                        Target.shipped("jvm").orElseThrow());
        List<Diagnostic> problems = new ArrayList<>(generation.findings());
        if (problems.isEmpty()) {
            problems.addAll(OversizedCode.in(generation));
        }
        findings.addAll(problems);
        if (problems.isEmpty()) {
            compile(generation);
            requirements.add(requirement(watch, promise, generation.layout()));
        }
    }

    private void compile(Generation generation) {
        Map<String, String> sources = new LinkedHashMap<>();
        for (GeneratedFile file : generation.files()) {
            sources.put(file.path(), file.text());
        }
        Compilation compilation = MemoryCompiler.compile(sources, Map.of(), ClassFiles.RUNTIME);
        if (!compilation.problems().isEmpty()) {
            throw new IllegalStateException(compilation.problems().toString());
        }
        classes.putAll(compilation.classes());
    }

    private static JointRequirement requirement(
            JointWatch watch, Promise promise, CodeLayout layout) {
        Component required = promise.component();
        List<CodeLayout.Place> places =
                promise.automata().stream()
                        .map(automaton -> Monitors.name(required, List.of(automaton)))
                        .map(name -> Objects.requireNonNull(layout.components().get(name)))
                        .toList();
        return new JointRequirement(
                watch.name(),
                places.stream().map(CodeLayout.Place::className).toList(),
                arguments(promise),
                required.ports().stream().map(port -> port(port, places.get(0))).toList());
    }

    /** All monitors of a component have its ports under the same names. */
    private static WatchedPort port(Port port, CodeLayout.Place place) {
        return new WatchedPort(
                port.name(),
                Objects.requireNonNull(place.messages().get(port.name())),
                place.presences().getOrDefault(port.name(), ""),
                port.type().name(),
                port.total());
    }

    private static List<String> arguments(Promise promise) {
        List<String> arguments = new ArrayList<>();
        for (Parameter each : promise.component().parameters()) {
            FieldValue value = new FieldValue(each.type());
            arguments.add(value.of(promise.arguments().get(arguments.size())).toString());
        }
        return arguments;
    }
}
