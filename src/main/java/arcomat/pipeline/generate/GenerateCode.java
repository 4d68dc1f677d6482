package arcomat.pipeline.generate;

import arcomat.generate.Deployment;
import arcomat.generate.Generation;
import arcomat.generate.Generator;
import arcomat.generate.Request;
import arcomat.generate.Target;
import arcomat.generate.monitor.SelfWatch;
import arcomat.generate.plan.Choosing;
import arcomat.pipeline.PathNames;
import arcomat.pipeline.Session;
import arcomat.pipeline.Task;
import arcomat.pipeline.WrongUse;
import arcomat.pipeline.check.Asked;
import arcomat.pipeline.check.CheckResult;
import arcomat.pipeline.check.CheckedAnswer;
import arcomat.pipeline.check.CheckedModels;
import arcomat.pipeline.check.LoadedModels;
import arcomat.pipeline.check.LoweredModels;
import arcomat.pipeline.check.MainComponent;
import arcomat.pipeline.compile.OversizedCode;
import arcomat.pipeline.file.OutputFolder;
import arcomat.source.Diagnostic;
import arcomat.source.Severity;
import arcomat.symbols.Workspace;
import arcomat.symbols.bodies.ComponentSymbol;

import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;

/**
 * Checks models for what code needs, generates it and writes it, all or nothing. What libraries of
 * the session have as code of their own is left out; programs for the brick hold all they need.
 *
 * @param target a shipped target, or a folder of templates
 * @param out the folder to be written, as a whole
 * @param main the only component that gets a program; empty for all that are to be deployed
 * @param randomChoice whether the code draws where the model leaves a choice; else it takes the
 *     first alternative in text order
 * @param monitors requirements that programs watch themselves for, as written
 */
public record GenerateCode(
        String target,
        String out,
        Optional<String> main,
        boolean randomChoice,
        List<String> monitors,
        List<String> paths)
        implements Task<CheckedAnswer<GenerateCode.Made>> {
    private static final String BRICK = "lejos";

    /**
     * What came of it.
     *
     * @param files paths of the files that were written, below the output folder
     * @param robots programs for the brick among them, if the target makes such
     * @param watches what these watch themselves for
     */
    public record Made(
            List<String> files, List<RobotBuilder.BrickProgram> robots, List<RobotWatch> watches) {}

    /**
     * What is to be written.
     *
     * @param result with findings about code, too; nothing is written where there are errors
     */
    private record Draft(
            CheckResult result,
            Map<String, byte[]> output,
            RobotBuilder.Result built,
            List<RobotWatch> watches) {}

    /**
     * What a robot watches itself for.
     *
     * @param robot qualified name of the component that its program runs
     * @param part path of the part that is watched; empty for the robot itself
     * @param requirement its name and line
     * @param goesOn whether the robot goes on after a violation
     */
    public record RobotWatch(String robot, String part, String requirement, boolean goesOn) {
        static RobotWatch of(SelfWatch watch) {
            return new RobotWatch(
                    watch.program().qualifiedName(),
                    watch.part(),
                    GenerateMonitor.requirement(watch.required(), watch.automaton()),
                    watch.goesOn());
        }
    }

    /**
     * Findings are about models, templates and code.
     *
     * @throws WrongUse where this does not fit the models, or the folder cannot be written
     */
    @Override
    public CheckedAnswer<Made> run(Session session) throws WrongUse {
        Target code = Targets.find(target, session.names());
        if (!monitors.isEmpty() && !code.isForBrick()) {
            throw new WrongUse(
                    "only programs for the brick watch themselves; arcomat monitor writes what"
                            + " watches other code");
        }
        CheckedModels checked = CheckedModels.checkToRun(paths, asked(), this::executable, session);
        if (checked.hasErrors()) {
            return CheckedAnswer.refused(checked.result());
        }
        Draft draft = draft(code, checked.lower(session), session);
        return draft.result().hasErrors()
                ? CheckedAnswer.refused(draft.result())
                : CheckedAnswer.of(draft.result(), write(draft, session));
    }

    /**
     * Makes the program of one component and writes nothing, for somebody who wants to know what it
     * would be like.
     *
     * @param models as somebody else has read them
     * @throws WrongUse where the component cannot be a program by itself
     */
    public static CheckedAnswer<RobotBuilder.BrickProgram> program(
            String component, LoadedModels models, Session session) throws WrongUse {
        GenerateCode code =
                new GenerateCode(
                        BRICK, "", Optional.of(component), false, List.of(), models.named());
        CheckedModels checked =
                CheckedModels.checkToRun(models, code.asked(), code::executable, session);
        if (checked.hasErrors()) {
            return CheckedAnswer.refused(checked.result());
        }
        Target target = Targets.find(BRICK, session.names());
        Draft draft = code.draft(target, checked.lower(session), session);
        return draft.result().hasErrors()
                ? CheckedAnswer.refused(draft.result())
                : CheckedAnswer.of(draft.result(), draft.built().robots().get(0));
    }

    private Draft draft(Target target, LoweredModels models, Session session) throws WrongUse {
        session.progress().step("generating");
        CheckedModels checked = models.checked();
        PathNames names = session.names();
        Implementations implementations =
                Implementations.find(target, checked.loaded().roots(names), names);
        Deployment deployed = Deployment.of(models.own());
        Request code = wanted(models, deployed).with(implementations.texts());
        List<SelfWatch> watches = WatchedParts.of(monitors, code.programs(), models);
        Generation generation = Generator.generate(code.watching(watches), target);
        List<Diagnostic> findings = new ArrayList<>(checked.findings());
        findings.addAll(generation.findings());
        if (main.isEmpty()) {
            findings.addAll(notDeployed(deployed, target));
        }
        if (!target.isForBrick()) {
            session.progress().step("looking at the size of code");
            findings.addAll(OversizedCode.in(generation));
        }
        CheckResult result = checked.result().with(findings);
        RobotBuilder.Result built = RobotBuilder.NOTHING;
        if (target.isForBrick() && !result.hasErrors()) {
            session.progress().step("compiling for the brick");
            built = RobotBuilder.build(generation, implementations);
            findings.addAll(built.findings());
            result = checked.result().with(findings);
        }
        Map<String, byte[]> output = output(generation, implementations, built);
        if (!target.isForBrick() && !result.hasErrors()) {
            // Programs for the brick hold all that they need.
            LibraryCode.of(target, choosing(), session).leaveOutOf(output);
        }
        return new Draft(result, output, built, watches.stream().map(RobotWatch::of).toList());
    }

    private Made write(Draft draft, Session session) throws WrongUse {
        Map<String, byte[]> output = draft.output();
        session.progress().step("writing", output.size(), "file");
        OutputFolder.replace(session.names().resolve(out), out, output);
        return new Made(List.copyOf(output.keySet()), draft.built().robots(), draft.watches());
    }

    /** What runs, and what it watches itself for; everything where nothing says what runs. */
    private Asked asked() {
        if (main.isEmpty()) {
            return Asked.EVERYTHING;
        }
        List<String> named = new ArrayList<>(WatchedParts.requirements(monitors));
        named.add(main.get());
        return Asked.components(named);
    }

    /** What the user wrote by hand stands beside what was generated for it. */
    private static Map<String, byte[]> output(
            Generation generation, Implementations implementations, RobotBuilder.Result built) {
        Map<String, byte[]> output = new LinkedHashMap<>();
        implementations
                .with(generation)
                .forEach((path, text) -> output.put(path, text.getBytes(StandardCharsets.UTF_8)));
        output.putAll(built.jars());
        return output;
    }

    /** What code is to be made of; nothing where {@code --main} names nothing. */
    private List<ComponentSymbol> executable(Workspace models, LoadedModels loaded) {
        if (main.isPresent()) {
            return MainComponent.symbols(main.get(), models);
        }
        return models.components().stream()
                .filter(each -> !loaded.isOfLibrary(each.node().span().file().path()))
                .toList();
    }

    private Choosing choosing() {
        return randomChoice ? Choosing.RANDOM : Choosing.FIRST;
    }

    /** Who generates for the brick wants the programs; elsewhere there is more than these. */
    private static List<Diagnostic> notDeployed(Deployment deployed, Target target) {
        Severity severity = target.isForBrick() ? Severity.ERROR : Severity.WARNING;
        return deployed.findings().stream().map(each -> each.withSeverity(severity)).toList();
    }

    private Request wanted(LoweredModels models, Deployment deployed) throws WrongUse {
        if (main.isEmpty()) {
            return Request.all(deployed, choosing());
        }
        return Request.program(MainComponent.find(main.get(), models).closed(), choosing());
    }
}
