package arcomat.live;

import arcomat.check.Checks;
import arcomat.check.Review;
import arcomat.check.law.Profile;
import arcomat.lower.Lowering;
import arcomat.pipeline.check.CheckedModels;
import arcomat.pipeline.check.LoadedModels;
import arcomat.pipeline.check.LoweredModels;
import arcomat.source.Diagnostic;
import arcomat.source.SourceFile;
import arcomat.source.Suppressed;
import arcomat.symbols.Workspace;
import arcomat.symbols.signatures.BehaviourReader;
import arcomat.translate.HouseLanguages;
import arcomat.tree.Recovered;
import arcomat.tree.Unit;

import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.TreeSet;
import java.util.stream.Stream;

/**
 * The models on the page: texts, what is found in them, and what they mean where nothing is wrong.
 *
 * @param lowered empty where there is an error
 * @param shown what can be drawn: without files that have errors, and those that need them
 */
record OpenModels(CheckedModels checked, Optional<LoweredModels> lowered, LoweredModels shown) {

    /**
     * Reads and checks texts as {@code arcomat check} does with files.
     *
     * @param needed paths of those that only lie around those that are worked on
     */
    static OpenModels read(ReadTexts texts, Set<String> needed) {
        LoadedModels loaded = load(texts, needed);
        BehaviourReader reader = HouseLanguages.readerHere();
        Workspace workspace = Workspace.of(loaded.units(), loaded.broken(), reader);
        Review review =
                Checks.reviewAlone(workspace, Profile.REQUIREMENTS, unit -> true, () -> {})
                        .and(
                                Checks.reviewRecoveredAlone(
                                        reader,
                                        loaded.recovered(),
                                        loaded.units(),
                                        loaded.broken(),
                                        Profile.REQUIREMENTS));
        CheckedModels checked = CheckedModels.of(loaded, workspace, review);
        Set<String> wrong = filesWithErrors(checked);
        if (wrong.isEmpty()) {
            LoweredModels all = new LoweredModels(checked, Lowering.lower(workspace));
            return new OpenModels(checked, Optional.of(all), all);
        }
        return new OpenModels(checked, Optional.empty(), lowered(loaded.without(wrong), reader));
    }

    /** Errors that are meant are among them. */
    private static Set<String> filesWithErrors(CheckedModels checked) {
        Set<String> files = new HashSet<>(checked.loaded().broken());
        Stream.concat(
                        checked.findings().stream(),
                        checked.suppressed().stream().map(Suppressed::finding))
                .filter(Diagnostic::isError)
                .forEach(each -> files.add(each.span().file().path()));
        return files;
    }

    /** Of models in which nothing is wrong. */
    private static LoweredModels lowered(LoadedModels whole, BehaviourReader reader) {
        Workspace workspace = Workspace.of(whole.units(), whole.broken(), reader);
        CheckedModels checked =
                CheckedModels.of(whole, workspace, new Review(List.of(), List.of()));
        return new LoweredModels(checked, Lowering.lower(workspace));
    }

    private static LoadedModels load(ReadTexts texts, Set<String> needed) {
        List<Unit> units = new ArrayList<>();
        List<Recovered> recovered = new ArrayList<>();
        Set<String> broken = new HashSet<>();
        TreeSet<Diagnostic> findings = new TreeSet<>(Diagnostic.ORDER);
        texts.all()
                .forEach(
                        (file, parsed) -> {
                            findings.addAll(parsed.findings());
                            parsed.recovered().ifPresent(recovered::add);
                            parsed.unit()
                                    .ifPresentOrElse(units::add, () -> broken.add(file.path()));
                        });
        List<SourceFile> files = List.copyOf(texts.all().keySet());
        List<String> named =
                files.stream()
                        .map(SourceFile::path)
                        .filter(path -> !needed.contains(path))
                        .toList();
        return new LoadedModels(
                named, files, units, recovered, broken, List.copyOf(findings), needed, Set.of());
    }
}
