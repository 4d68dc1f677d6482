package arcomat.pipeline.generate;

import arcomat.generate.Generation;
import arcomat.generate.Generator;
import arcomat.generate.Request;
import arcomat.generate.Target;
import arcomat.generate.monitor.SelfWatch;
import arcomat.generate.plan.Choosing;
import arcomat.model.Model;
import arcomat.pipeline.check.Asked;
import arcomat.pipeline.check.CheckResult;
import arcomat.pipeline.check.CheckedModels;
import arcomat.pipeline.check.MainComponent;
import arcomat.pipeline.compile.OversizedCode;
import arcomat.pipeline.file.OutputFolder;
import arcomat.pipeline.monitor.WatchedParts;
import arcomat.pipeline.step.PathNames;
import arcomat.pipeline.step.Progress;
import arcomat.pipeline.step.WrongUse;
import arcomat.source.Diagnostic;
import arcomat.symbols.Workspace;
import arcomat.symbols.bodies.ComponentSymbol;

import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;

/** Checks models for what code needs, generates it and writes it, all or nothing. */
public final class GenerateStep {
    private GenerateStep() {}

    public static GenerationResult run(
            GenerationRequest request, List<String> paths, PathNames names, Progress progress)
            throws WrongUse {
        Target target = Targets.find(request.target(), names);
        requireWatching(request, target);
        CheckedModels checked =
                CheckedModels.checkToRun(
                        paths,
                        asked(request),
                        models -> wantedOf(request, models),
                        names,
                        progress);
        if (checked.hasErrors()) {
            return refused(checked.result());
        }
        Model model = checked.lower(progress);
        progress.step("generating");
        Implementations implementations =
                Implementations.find(target, checked.loaded().roots(names), names);
        Request code = wanted(request, checked, model).with(implementations.texts());
        List<SelfWatch> watches =
                WatchedParts.of(request.monitors(), code.programs(), checked, model);
        Request wanted = code.watching(watches);
        Generation generation = Generator.generate(wanted, target);
        List<Diagnostic> findings = new ArrayList<>(checked.findings());
        findings.addAll(generation.findings());
        if (!target.isForBrick()) {
            progress.step("looking at the size of code");
            findings.addAll(OversizedCode.in(generation));
        }
        CheckResult result = checked.result().with(findings);
        if (result.hasErrors()) {
            return refused(result);
        }
        RobotBuilder.Result built = RobotBuilder.NOTHING;
        if (target.isForBrick()) {
            progress.step("compiling for the brick");
            built = RobotBuilder.build(generation, implementations);
            findings.addAll(built.findings());
            result = checked.result().with(findings);
        }
        if (result.hasErrors()) {
            return refused(result);
        }
        Map<String, byte[]> output = output(generation, implementations, built);
        progress.step("writing", output.size(), "file");
        OutputFolder.replace(names.resolve(request.out()), request.out(), output);
        return new GenerationResult(
                result,
                List.copyOf(output.keySet()),
                built.robots(),
                watches.stream().map(RobotWatch::of).toList());
    }

    /** What runs, and what it watches itself for; everything where nothing says what runs. */
    private static Asked asked(GenerationRequest request) {
        if (request.main().isEmpty()) {
            return Asked.EVERYTHING;
        }
        List<String> named = new ArrayList<>(WatchedParts.requirements(request.monitors()));
        named.add(request.main().get());
        return Asked.components(named);
    }

    private static void requireWatching(GenerationRequest request, Target target) throws WrongUse {
        if (!request.monitors().isEmpty() && !target.isForBrick()) {
            throw new WrongUse(
                    "only programs for the brick watch themselves; arcomat monitor writes what"
                            + " watches other code");
        }
    }

    private static GenerationResult refused(CheckResult result) {
        return new GenerationResult(result, List.of(), List.of(), List.of());
    }

    /** What the user wrote by hand stands beside what was generated for it. */
    private static Map<String, byte[]> output(
            Generation generation, Implementations implementations, RobotBuilder.Result built) {
        Map<String, byte[]> output = new LinkedHashMap<>();
        implementations.own().forEach((path, file) -> output.put(path, bytes(file.text())));
        generation.files().forEach(file -> output.put(file.path(), bytes(file.text())));
        output.putAll(built.jars());
        return output;
    }

    private static byte[] bytes(String text) {
        return text.getBytes(StandardCharsets.UTF_8);
    }

    /** What code is to be made of; nothing where {@code --main} names nothing. */
    private static List<ComponentSymbol> wantedOf(GenerationRequest request, Workspace models) {
        return request.main()
                .map(main -> MainComponent.symbols(main, models))
                .orElseGet(models::components);
    }

    private static Request wanted(GenerationRequest request, CheckedModels checked, Model model)
            throws WrongUse {
        Choosing choosing = request.randomChoice() ? Choosing.RANDOM : Choosing.FIRST;
        if (request.main().isEmpty()) {
            return Request.all(model, choosing);
        }
        MainComponent main = MainComponent.find(request.main().get(), checked, model);
        if (!main.component().parameters().isEmpty()) {
            throw new WrongUse(
                    "a program has nobody to give it arguments, and '"
                            + main.component().qualifiedName()
                            + "' takes some; give --main a component with a part that says them");
        }
        return Request.program(main.component(), choosing);
    }
}
