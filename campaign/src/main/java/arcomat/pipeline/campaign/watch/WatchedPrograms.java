package arcomat.pipeline.campaign.watch;

import arcomat.campaign.Watched;
import arcomat.generate.CodeLayout;
import arcomat.generate.GeneratedFile;
import arcomat.generate.Generation;
import arcomat.generate.Generator;
import arcomat.generate.Request;
import arcomat.generate.Target;
import arcomat.generate.monitor.SelfWatch;
import arcomat.generate.plan.Choosing;
import arcomat.model.Automaton;
import arcomat.model.Component;
import arcomat.pipeline.Session;
import arcomat.pipeline.WrongUse;
import arcomat.pipeline.brick.JarReader;
import arcomat.pipeline.check.LoweredModels;
import arcomat.pipeline.generate.Implementations;
import arcomat.pipeline.generate.RobotBuilder;
import arcomat.pipeline.generate.Targets;
import arcomat.pipeline.generate.WatchedParts;
import arcomat.sim.load.Program;
import arcomat.source.Diagnostic;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.Set;
import java.util.TreeMap;

/**
 * Makes programs anew that watch themselves for what a campaign asks. Whatever a requirement says,
 * its robot goes on after a violation: the event is what is asked for, and the rest of the run.
 */
final class WatchedPrograms {
    private static final String TARGET = "lejos";

    private final List<Watched> wanted;
    private final LoweredModels models;
    private final Session session;
    private final Target target;
    private final Implementations own;
    private final Map<String, Program> programs = new TreeMap<>();
    private final Map<String, CodeLayout> layouts = new TreeMap<>();
    private final Map<String, String> monitors = new TreeMap<>();
    private final Map<Watched, WrongUse> refused = new LinkedHashMap<>();
    private final List<Diagnostic> findings = new ArrayList<>();

    private WatchedPrograms(List<Watched> wanted, LoweredModels models, Session session)
            throws WrongUse {
        this.wanted = wanted;
        this.models = models;
        this.session = session;
        this.target = Targets.find(TARGET, session.names());
        this.own =
                Implementations.find(
                        target, models.checked().loaded().roots(session.names()), session.names());
    }

    /**
     * What came of one model root.
     *
     * @param programs those that watch something, by what worlds say of them
     * @param layouts where these have what their models have
     * @param monitors columns by the full names of the classes that watch
     * @param refused why there is nothing here that could be watched for a requirement
     * @param findings about code
     */
    record Result(
            Map<String, Program> programs,
            Map<String, CodeLayout> layouts,
            Map<String, String> monitors,
            Map<Watched, WrongUse> refused,
            List<Diagnostic> findings) {}

    /**
     * @param components that programs run, by what worlds say of them
     */
    static Result of(
            List<Watched> wanted,
            Map<String, Component> components,
            LoweredModels models,
            Session session)
            throws WrongUse {
        WatchedPrograms all = new WatchedPrograms(wanted, models, session);
        Map<Watched, List<SelfWatch>> watches = all.watches(List.copyOf(components.values()));
        for (Map.Entry<String, Component> each : components.entrySet()) {
            all.make(each.getKey(), each.getValue(), watches);
        }
        return new Result(all.programs, all.layouts, all.monitors, all.refused, all.findings);
    }

    private Map<Watched, List<SelfWatch>> watches(List<Component> components) {
        Map<Watched, List<SelfWatch>> watches = new LinkedHashMap<>();
        for (Watched each : wanted) {
            try {
                List<String> written = List.of(each.requirement());
                watches.put(each, goingOn(WatchedParts.of(written, components, models)));
            } catch (WrongUse e) {
                refused.put(each, e);
            }
        }
        return watches;
    }

    private static List<SelfWatch> goingOn(List<SelfWatch> watches) {
        return watches.stream()
                .map(
                        each ->
                                new SelfWatch(
                                        each.program(),
                                        each.part(),
                                        each.running(),
                                        each.required(),
                                        each.automaton().with(Automaton.Violated.CONTINUE),
                                        each.arguments()))
                .toList();
    }

    private void make(String key, Component program, Map<Watched, List<SelfWatch>> watches)
            throws WrongUse {
        List<SelfWatch> all = new ArrayList<>();
        Set<String> plain = files(generation(program, List.of()));
        for (Map.Entry<Watched, List<SelfWatch>> each : watches.entrySet()) {
            List<SelfWatch> here =
                    each.getValue().stream().filter(w -> w.program().equals(program)).toList();
            if (!here.isEmpty()) {
                all.addAll(here);
                Set<String> added = files(generation(program, here));
                added.removeAll(plain);
                added.forEach(file -> name(file, each.getKey()));
            }
        }
        if (!all.isEmpty()) {
            build(key, generation(program, all));
        }
    }

    private Generation generation(Component program, List<SelfWatch> watches) {
        Request request = Request.program(program, Choosing.FIRST).with(own.texts());
        return Generator.generate(request.watching(watches), target);
    }

    private static Set<String> files(Generation generation) {
        Set<String> paths = new LinkedHashSet<>();
        generation.files().stream().map(GeneratedFile::path).forEach(paths::add);
        return paths;
    }

    /** The class that a generated file has is the monitor of a requirement. */
    private void name(String file, Watched watched) {
        String type = file.replaceFirst("\\.java$", "").replace('/', '.');
        String before = monitors.putIfAbsent(type, watched.name());
        if (before != null && !before.equals(watched.name())) {
            findings.add(
                    Diagnostic.error(
                            WatchFreight.NOT_WATCHED,
                            watched.place(),
                            "'%s' is watched for this requirement already".formatted(before)));
        }
    }

    private void build(String key, Generation generation) throws WrongUse {
        session.progress().step("making a program that watches itself");
        findings.addAll(generation.findings());
        if (generation.findings().stream().anyMatch(Diagnostic::isError)) {
            return;
        }
        RobotBuilder.Result built = RobotBuilder.build(generation, own);
        findings.addAll(built.findings().stream().filter(Diagnostic::isError).toList());
        if (built.jars().isEmpty()) {
            return;
        }
        String path = built.robots().get(0).jar();
        byte[] jar = Objects.requireNonNull(built.jars().get(path));
        programs.put(key, JarReader.made(path, jar).program());
        layouts.put(key, generation.layout());
    }
}
