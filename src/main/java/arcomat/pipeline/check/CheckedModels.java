package arcomat.pipeline.check;

import arcomat.check.Checks;
import arcomat.check.LawBook;
import arcomat.check.Review;
import arcomat.check.law.Profile;
import arcomat.lower.Lowering;
import arcomat.pipeline.Session;
import arcomat.pipeline.file.FileFindings;
import arcomat.source.Diagnostic;
import arcomat.source.SourceFile;
import arcomat.source.Suppressed;
import arcomat.symbols.Workspace;
import arcomat.symbols.bodies.ComponentSymbol;
import arcomat.translate.HouseLanguages;
import arcomat.tree.Unit;

import java.util.Collection;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.TreeSet;
import java.util.function.BiFunction;
import java.util.function.Predicate;
import java.util.stream.Collectors;

/**
 * The files behind a set of paths, read, parsed and checked: every finding of every file in one
 * run.
 *
 * @param findings to be shown, ordered, each once
 * @param suppressed what the models declare to be meant and what does not keep them from their use
 * @param aside what is left out
 */
public record CheckedModels(
        LoadedModels loaded,
        Workspace workspace,
        List<Diagnostic> findings,
        List<Suppressed> suppressed,
        Aside aside) {

    /** Checks models for their own sake. */
    public static CheckedModels check(List<String> paths, Profile profile, Session session) {
        LoadedModels loaded = ModelLoader.load(paths, session);
        Workspace workspace = examined(loaded, session);
        return of(loaded, workspace, review(loaded, workspace, profile, session));
    }

    /**
     * Checks models that are about to run: no error is excused by being meant. Files with errors
     * are left out, and what needs them, where the rest is what is asked.
     *
     * @param asked what is wanted of them
     * @param executable components that code is made of; requirements beside them need not be
     *     executable
     */
    public static CheckedModels checkToRun(
            List<String> paths,
            Asked asked,
            BiFunction<Workspace, LoadedModels, Collection<ComponentSymbol>> executable,
            Session session) {
        return checkToRun(ModelLoader.load(paths, session), asked, executable, session);
    }

    /** As above, of models that somebody else has read. */
    public static CheckedModels checkToRun(
            LoadedModels loaded,
            Asked asked,
            BiFunction<Workspace, LoadedModels, Collection<ComponentSymbol>> executable,
            Session session) {
        CheckedModels all = checkWhole(loaded, executable, session);
        return all.without(all.filesWithErrors(), session)
                .filter(rest -> rest.hasNamed() && asked.isIn(rest.workspace()))
                .orElse(all);
    }

    /** As above, for questions about models: no code is made of them. */
    public static CheckedModels checkToExamine(List<String> paths, Asked asked, Session session) {
        return checkToRun(paths, asked, (models, files) -> List.of(), session);
    }

    /** As above, of models that somebody else has read. */
    static CheckedModels checkToExamine(LoadedModels loaded, Asked asked, Session session) {
        return checkToRun(loaded, asked, (models, files) -> List.of(), session);
    }

    /** Whether something is left of what the user named. */
    private boolean hasNamed() {
        return loaded.units().stream().anyMatch(unit -> loaded.isNamedByUser(unit.file().path()));
    }

    /** Those where errors are found, and those that errors are about as well. */
    private Set<String> filesWithErrors() {
        Set<String> files = new TreeSet<>(loaded.broken());
        for (Diagnostic each : findings) {
            if (each.isError()) {
                files.add(each.span().file().path());
                each.related().forEach(place -> files.add(place.span().file().path()));
            }
        }
        return files;
    }

    /** Without some files and those that need them, if there are. */
    private Optional<CheckedModels> without(Set<String> wrong, Session session) {
        if (wrong.isEmpty()
                || loaded.findings().stream().anyMatch(FileFindings::isUnreadableInput)) {
            return Optional.empty();
        }
        Set<String> whole = WholeFiles.in(loaded, wrong);
        LoadedModels rest = loaded.only(whole);
        List<SourceFile> others =
                loaded.sources().stream().filter(file -> !whole.contains(file.path())).toList();
        Set<String> paths = others.stream().map(SourceFile::path).collect(Collectors.toSet());
        Predicate<Diagnostic> isAside = each -> paths.contains(each.span().file().path());
        return Optional.of(
                new CheckedModels(
                        rest,
                        workspace(rest, session),
                        findings.stream().filter(isAside.negate()).toList(),
                        suppressed.stream().filter(each -> !isAside.test(each.finding())).toList(),
                        Aside.of(others, findings.stream().filter(isAside).toList())));
    }

    /** As {@link #checkToExamine} of all that is whole, but stream tests are not looked at. */
    public static CheckedModels checkWithoutTests(List<String> paths, Session session) {
        LoadedModels loaded = ModelLoader.load(paths, session).withoutTests();
        CheckedModels all = checkWhole(loaded, (models, files) -> List.of(), session);
        return all.without(loaded.broken(), session).orElse(all);
    }

    private static CheckedModels checkWhole(
            LoadedModels loaded,
            BiFunction<Workspace, LoadedModels, Collection<ComponentSymbol>> executable,
            Session session) {
        Workspace workspace = examined(loaded, session);
        Review review = review(loaded, workspace, Profile.REQUIREMENTS, session);
        TreeSet<Diagnostic> findings = new TreeSet<>(Diagnostic.ORDER);
        findings.addAll(review.findings());
        review.suppressed().stream()
                .map(Suppressed::finding)
                .filter(Diagnostic::isError)
                .forEach(findings::add);
        List<Suppressed> meant =
                review.suppressed().stream().filter(each -> !each.finding().isError()).toList();
        MadeOf code = MadeOf.those(executable.apply(workspace, loaded));
        if (!code.isEmpty()) {
            findings.removeIf(code::contains);
            Checks.review(
                            session.laws(),
                            workspace,
                            Profile.EXECUTABLE,
                            unit -> true,
                            session.progress()::goOn)
                    .findings()
                    .stream()
                    .filter(code::contains)
                    .forEach(findings::add);
        }
        return of(loaded, workspace, findings, meant);
    }

    private static Workspace examined(LoadedModels loaded, Session session) {
        session.progress().step("checking", loaded.units().size(), "model");
        return workspace(loaded, session);
    }

    private static Workspace workspace(LoadedModels loaded, Session session) {
        return Workspace.of(
                loaded.units(),
                loaded.broken(),
                List.of(),
                HouseLanguages.and(session.laws().reader()));
    }

    private static Review review(
            LoadedModels loaded, Workspace workspace, Profile profile, Session session) {
        return review(
                        session.laws(),
                        workspace,
                        profile,
                        unit -> true,
                        loaded.libraries(),
                        session.progress()::goOn)
                .and(
                        Checks.reviewRecovered(
                                session.laws(),
                                HouseLanguages.and(session.laws().reader()),
                                loaded.recovered(),
                                loaded.units(),
                                loaded.broken(),
                                List.of(),
                                profile));
    }

    /**
     * Asks the laws about units. Models of libraries are complete where they belong, and what they
     * are there for is not asked here: they may be requirements wherever they are used.
     *
     * @param asked which units are looked at
     * @param libraries paths of their models
     * @param goOn asked now and then; it may throw what ends the work
     */
    public static Review review(
            LawBook laws,
            Workspace workspace,
            Profile profile,
            Predicate<Unit> asked,
            Set<String> libraries,
            Runnable goOn) {
        if (libraries.isEmpty()) {
            return Checks.review(laws, workspace, profile, asked, goOn);
        }
        Predicate<SourceFile> foreign = file -> libraries.contains(file.path());
        return only(foreign.negate(), laws, workspace, profile, asked, goOn)
                .and(only(foreign, laws, workspace, Profile.REQUIREMENTS, asked, goOn));
    }

    /** Laws about all files together find what is wrong with others as well. */
    private static Review only(
            Predicate<SourceFile> files,
            LawBook laws,
            Workspace workspace,
            Profile profile,
            Predicate<Unit> asked,
            Runnable goOn) {
        Predicate<Unit> units = unit -> files.test(unit.file());
        Review all = Checks.review(laws, workspace, profile, asked.and(units), goOn);
        return new Review(
                all.findings().stream().filter(each -> files.test(each.span().file())).toList(),
                all.suppressed().stream()
                        .filter(each -> files.test(each.finding().span().file()))
                        .toList());
    }

    /** Models that somebody else has read and reviewed. */
    public static CheckedModels of(LoadedModels loaded, Workspace workspace, Review review) {
        return of(loaded, workspace, review.findings(), review.suppressed());
    }

    private static CheckedModels of(
            LoadedModels loaded,
            Workspace workspace,
            Collection<Diagnostic> found,
            List<Suppressed> meant) {
        TreeSet<Diagnostic> findings = new TreeSet<>(Diagnostic.ORDER);
        findings.addAll(loaded.findings());
        findings.addAll(found);
        findings.removeIf(finding -> !loaded.isShown(finding));
        if (loaded.findings().stream().anyMatch(Diagnostic::isError)) {
            // What does not parse may well be what is suppressed.
            findings.removeIf(Checks::isUnusedSuppression);
        }
        List<Suppressed> suppressed =
                meant.stream().filter(each -> loaded.isShown(each.finding())).toList();
        return new CheckedModels(
                loaded, workspace, List.copyOf(findings), suppressed, Aside.NOTHING);
    }

    public boolean hasErrors() {
        return findings.stream().anyMatch(Diagnostic::isError);
    }

    /** The meaning of the models; only without errors. */
    public LoweredModels lower(Session session) {
        session.progress().step("lowering");
        return new LoweredModels(this, Lowering.lower(workspace, session.progress()::goOn));
    }

    public CheckResult result() {
        return new CheckResult(findings, suppressed, loaded.named(), aside);
    }
}
