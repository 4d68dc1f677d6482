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
import arcomat.symbols.names.Lazy;
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
 * The models on the page: texts, and what is found in them. What they mean is found out where
 * somebody asks for it, since whoever is typing waits for the findings.
 */
final class OpenModels {
    private final CheckedModels checked;
    private final Set<String> wrong;
    private final BehaviourReader reader;
    private final Lazy<LoweredModels> shown = new Lazy<>(this::withoutErrors);

    private OpenModels(CheckedModels checked, BehaviourReader reader) {
        this.checked = checked;
        this.reader = reader;
        wrong = filesWithErrors(checked);
    }

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
        return new OpenModels(CheckedModels.of(loaded, workspace, review), reader);
    }

    CheckedModels checked() {
        return checked;
    }

    /** Whether there is no error. */
    boolean areWhole() {
        return wrong.isEmpty();
    }

    /** Empty where there is an error. */
    Optional<LoweredModels> lowered() {
        return areWhole() ? Optional.of(shown()) : Optional.empty();
    }

    /** What can be drawn: without files that have errors, and those that need them. */
    LoweredModels shown() {
        return shown.get();
    }

    private LoweredModels withoutErrors() {
        if (areWhole()) {
            return new LoweredModels(checked, Lowering.lower(checked.workspace()));
        }
        LoadedModels whole = checked.loaded().without(wrong);
        Workspace workspace = Workspace.of(whole.units(), whole.broken(), reader);
        CheckedModels nothing =
                CheckedModels.of(whole, workspace, new Review(List.of(), List.of()));
        return new LoweredModels(nothing, Lowering.lower(workspace));
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
