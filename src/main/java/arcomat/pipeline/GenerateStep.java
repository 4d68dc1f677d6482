package arcomat.pipeline;

import arcomat.generate.Choosing;
import arcomat.generate.GeneratedFile;
import arcomat.generate.Generation;
import arcomat.generate.Generator;
import arcomat.generate.Request;
import arcomat.generate.Target;
import arcomat.model.Model;
import arcomat.source.Diagnostic;
import arcomat.symbols.ComponentSymbol;
import arcomat.symbols.Workspace;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;

/** Checks models for what code needs, generates it and writes it, all or nothing. */
final class GenerateStep {
    private GenerateStep() {}

    static GenerationResult run(
            GenerationRequest request, List<String> paths, PathNames names, Progress progress)
            throws WrongUse {
        Target target = Targets.find(request.target(), names);
        CheckedModels checked =
                CheckedModels.checkToRun(
                        paths, models -> wantedOf(request, models), names, progress);
        if (checked.hasErrors()) {
            return new GenerationResult(checked.result(), List.of());
        }
        Model model = checked.lower(progress);
        progress.step("generating");
        Request wanted = wanted(request, checked, model);
        Generation generation =
                Generator.generate(
                        wanted.with(Targets.implementations(target, paths, names)), target);
        List<Diagnostic> findings = new ArrayList<>(checked.findings());
        findings.addAll(generation.findings());
        CheckResult result = new CheckResult(findings, checked.loaded().files());
        if (result.hasErrors()) {
            return new GenerationResult(result, List.of());
        }
        Map<String, String> files = new LinkedHashMap<>();
        for (GeneratedFile file : generation.files()) {
            files.put(file.path(), file.text());
        }
        progress.step("writing", files.size(), "file");
        OutputFolder.replace(names.resolve(request.out()), request.out(), files);
        return new GenerationResult(result, List.copyOf(files.keySet()));
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
