package arcomat.pipeline;

import arcomat.check.Checks;
import arcomat.check.Profile;
import arcomat.lower.Lowering;
import arcomat.model.Model;
import arcomat.source.Diagnostic;
import arcomat.symbols.Workspace;

import java.util.List;
import java.util.TreeSet;

/**
 * The files behind a set of paths, read, parsed and checked: every finding of every file in one
 * run.
 *
 * @param findings to be shown, ordered, each once
 */
record CheckedModels(LoadedModels loaded, Workspace workspace, List<Diagnostic> findings) {

    static CheckedModels check(
            List<String> paths, Profile profile, PathNames names, Progress progress) {
        LoadedModels loaded = ModelLoader.load(paths, names, progress);
        progress.step("checking " + loaded.units().size() + " models");
        Workspace workspace = Workspace.of(loaded.units(), loaded.broken());
        TreeSet<Diagnostic> findings = new TreeSet<>(Diagnostic.ORDER);
        findings.addAll(loaded.findings());
        findings.addAll(Checks.run(workspace, profile));
        findings.removeIf(finding -> !loaded.isShown(finding));
        return new CheckedModels(loaded, workspace, List.copyOf(findings));
    }

    boolean hasErrors() {
        return findings.stream().anyMatch(Diagnostic::isError);
    }

    /** The meaning of the models; only without errors. */
    Model lower(Progress progress) {
        progress.step("lowering");
        return Lowering.lower(workspace);
    }

    CheckResult result() {
        return new CheckResult(findings, loaded.files());
    }
}
