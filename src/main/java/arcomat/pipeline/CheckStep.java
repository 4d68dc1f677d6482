package arcomat.pipeline;

import arcomat.source.Diagnostic;

import java.util.ArrayList;
import java.util.List;

/** Reads, parses and checks: every finding of every file in one run. */
final class CheckStep {
    private CheckStep() {}

    static CheckResult run(
            List<String> paths, boolean executable, PathNames names, Progress progress) {
        LoadedModels loaded = ModelLoader.load(paths, names, progress);
        List<Diagnostic> findings = new ArrayList<>(loaded.findings());
        findings.removeIf(finding -> !loaded.isShown(finding));
        findings.sort(Diagnostic.ORDER);
        return new CheckResult(findings, loaded.files());
    }
}
