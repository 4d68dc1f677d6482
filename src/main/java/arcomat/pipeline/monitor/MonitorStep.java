package arcomat.pipeline.monitor;

import arcomat.analysis.refinement.Promise;
import arcomat.generate.GeneratedFile;
import arcomat.generate.Generation;
import arcomat.generate.Monitors;
import arcomat.generate.Target;
import arcomat.model.Automaton;
import arcomat.model.Component;
import arcomat.pipeline.check.Asked;
import arcomat.pipeline.check.CheckResult;
import arcomat.pipeline.check.CheckedModels;
import arcomat.pipeline.compile.OversizedCode;
import arcomat.pipeline.file.OutputFolder;
import arcomat.pipeline.step.PathNames;
import arcomat.pipeline.step.Progress;
import arcomat.pipeline.step.WrongUse;
import arcomat.source.Diagnostic;

import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;

/** Writes classes that watch a component, all of them or none. */
public final class MonitorStep {
    private MonitorStep() {}

    public static MonitorResult run(
            MonitorRequest request, List<String> paths, PathNames names, Progress progress)
            throws WrongUse {
        CheckedModels checked =
                CheckedModels.checkToExamine(
                        paths, Asked.components(List.of(request.component())), names, progress);
        if (checked.hasErrors()) {
            return new MonitorResult(checked.result(), "", List.of(), List.of());
        }
        Promise promise = Watches.promise(request.component(), checked, checked.lower(progress));
        Component watched = promise.component();
        progress.step("generating");
        Generation generation =
                Monitors.generate(watched, promise.automata(), Target.shipped("jvm").orElseThrow());
        List<Diagnostic> problems = new ArrayList<>(generation.findings());
        problems.addAll(OversizedCode.in(generation));
        if (!problems.isEmpty()) {
            List<Diagnostic> findings = new ArrayList<>(checked.findings());
            findings.addAll(problems);
            CheckResult result = checked.result().with(findings);
            return new MonitorResult(result, "", List.of(), List.of());
        }
        Map<String, byte[]> files = new LinkedHashMap<>();
        for (GeneratedFile file : generation.files()) {
            files.put(file.path(), file.text().getBytes(StandardCharsets.UTF_8));
        }
        OutputFolder.replace(names.resolve(request.out()), request.out(), files);
        String monitor = Monitors.name(watched, promise.automata());
        return new MonitorResult(
                checked.result(),
                generation.layout().components().get(monitor).className(),
                promise.automata().stream().map(a -> requirement(watched, a)).toList(),
                List.copyOf(files.keySet()));
    }

    private static String requirement(Component watched, Automaton automaton) {
        int line = automaton.span().startPosition().line();
        return watched.title(automaton) + " (line " + line + ")";
    }
}
