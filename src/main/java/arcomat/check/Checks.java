package arcomat.check;

import arcomat.check.guest.GuestLaws;
import arcomat.check.guest.GuestReview;
import arcomat.check.guest.ReadBehaviours;
import arcomat.check.law.Law;
import arcomat.check.law.Law.Needs;
import arcomat.check.law.Profile;
import arcomat.check.law.Suppressions;
import arcomat.check.law.Suppressions.Suppression;
import arcomat.check.stereotypes.SuppressionUsed;
import arcomat.check.walk.Listeners;
import arcomat.check.walk.Walk;
import arcomat.source.Diagnostic;
import arcomat.source.Suppressed;
import arcomat.symbols.Workspace;
import arcomat.symbols.names.Outline;
import arcomat.symbols.signatures.BehaviourReader;
import arcomat.tree.Recovered;
import arcomat.tree.Unit;

import java.time.Duration;
import java.util.ArrayList;
import java.util.Collection;
import java.util.HashMap;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.TreeSet;
import java.util.function.Consumer;
import java.util.function.Predicate;
import java.util.stream.Collector;
import java.util.stream.Collectors;
import java.util.stream.Stream;

/** The one way to ask the laws of a {@link LawBook}. */
public final class Checks {
    /** With fewer definitions one thread is done before a second one has started. */
    private static final int WORTH_A_SECOND_THREAD = 200;

    /** Laws look at a file in milliseconds; what takes longer than this does not end. */
    private static final Duration GUESTS_LIMIT = Duration.ofSeconds(60);

    private Checks() {}

    /** What the tool's own laws find in all files of a workspace, ordered, each once. */
    public static List<Diagnostic> run(Workspace workspace, Profile profile) {
        return review(LawBook.OWN, workspace, profile, unit -> true, () -> {}).findings();
    }

    /**
     * The findings, and those that the models declare to be meant.
     *
     * @param wanted files to look at; findings of laws about all files together may be about others
     * @param goOn asked before each step; it may throw what ends the work
     */
    public static Review review(
            LawBook book,
            Workspace workspace,
            Profile profile,
            Predicate<Unit> wanted,
            Runnable goOn) {
        List<Consumer<Walk>> steps = Walk.steps(workspace, wanted);
        Stream<Consumer<Walk>> stream =
                steps.size() > WORTH_A_SECOND_THREAD ? steps.parallelStream() : steps.stream();
        Walk walk = walk(stream, book, workspace, profile, goOn);
        List<Diagnostic> found = found(walk);
        if (!book.guests().isEmpty()) {
            found.addAll(
                    ReadBehaviours.by(book.guests()).findings(workspace, profile, wanted, goOn));
        }
        found.replaceAll(ForeignText.around(found, workspace)::told);
        List<Law> asked = new ArrayList<>(book.own());
        for (GuestLaws guest : book.guests()) {
            GuestReview.Outcome outcome =
                    new GuestReview(guest, GUESTS_LIMIT).run(workspace, profile, wanted, goOn);
            found.addAll(outcome.findings());
            if (outcome.whole()) {
                asked.addAll(guest.laws());
            }
        }
        return review(workspace, profile, walk.suppressions(), found, asked);
    }

    /**
     * The same by the tool's own laws and without a further thread, for where there is none, as in
     * a browser.
     */
    public static Review reviewAlone(
            Workspace workspace, Profile profile, Predicate<Unit> wanted, Runnable goOn) {
        Stream<Consumer<Walk>> steps = Walk.steps(workspace, wanted).stream();
        Walk walk = walk(steps, LawBook.OWN, workspace, profile, goOn);
        List<Diagnostic> found = found(walk);
        found.replaceAll(ForeignText.around(found, workspace)::told);
        return review(workspace, profile, walk.suppressions(), found, LawBook.OWN.own());
    }

    private static Walk walk(
            Stream<Consumer<Walk>> steps,
            LawBook book,
            Workspace workspace,
            Profile profile,
            Runnable goOn) {
        return steps.collect(
                Collector.of(
                        () -> new Walk(workspace, profile, new Listeners(book.own(), profile)),
                        (each, step) -> {
                            goOn.run();
                            step.accept(each);
                        },
                        Walk::join));
    }

    private static List<Diagnostic> found(Walk walk) {
        List<Diagnostic> found = new ArrayList<>();
        walk.findings().forEach(each -> found.addAll(each.diagnostics()));
        return found;
    }

    private static Review review(
            Workspace workspace,
            Profile profile,
            Suppressions suppressions,
            List<Diagnostic> found,
            List<Law> asked) {
        Set<Suppression> used = new HashSet<>();
        found.forEach(finding -> used.addAll(suppressions.covering(finding)));
        List<Diagnostic> all = new ArrayList<>(found);
        if (workspace.isComplete()) {
            all.addAll(SuppressionUsed.unused(suppressions, used, asked, profile).diagnostics());
        }
        return sort(all, suppressions, profile);
    }

    /**
     * The findings about the parts that could be read of files with syntax errors, as far as they
     * do not come from what could not be read.
     *
     * @param files what could be read of them
     * @param units the files that parse
     * @param brokenFiles paths of those that do not
     * @param others outlines of files that are not looked at
     * @param reader of behaviours that are not read yet
     */
    public static Review reviewRecovered(
            LawBook book,
            BehaviourReader reader,
            List<Recovered> files,
            List<Unit> units,
            Set<String> brokenFiles,
            List<Outline> others,
            Profile profile) {
        if (files.isEmpty()) {
            return new Review(List.of(), List.of());
        }
        Workspace around = Workspace.around(parts(files), units, brokenFiles, others, reader);
        Set<String> paths = paths(files);
        Review all =
                review(book, around, profile, unit -> paths.contains(unit.file().path()), () -> {});
        return sure(all, files, book);
    }

    /** The same by the tool's own laws and without a further thread. */
    public static Review reviewRecoveredAlone(
            BehaviourReader reader,
            List<Recovered> files,
            List<Unit> units,
            Set<String> brokenFiles,
            Profile profile) {
        if (files.isEmpty()) {
            return new Review(List.of(), List.of());
        }
        Workspace around = Workspace.around(parts(files), units, brokenFiles, List.of(), reader);
        Set<String> paths = paths(files);
        Predicate<Unit> wanted = unit -> paths.contains(unit.file().path());
        return sure(reviewAlone(around, profile, wanted, () -> {}), files, LawBook.OWN);
    }

    private static List<Unit> parts(List<Recovered> files) {
        return files.stream().map(Recovered::unit).toList();
    }

    private static Set<String> paths(List<Recovered> files) {
        return files.stream().map(each -> each.unit().file().path()).collect(Collectors.toSet());
    }

    /** What would be found as well if the files could be read as a whole. */
    private static Review sure(Review all, List<Recovered> files, LawBook book) {
        Map<String, Needs> needs =
                book.all().stream().collect(Collectors.toMap(Law::code, Law::needs));
        Map<String, SureFindings> sureOf = new HashMap<>();
        files.forEach(each -> sureOf.put(each.unit().file().path(), new SureFindings(each, needs)));
        Predicate<Diagnostic> sure =
                finding ->
                        Optional.ofNullable(sureOf.get(finding.span().file().path()))
                                .filter(those -> those.contains(finding))
                                .isPresent();
        return new Review(
                all.findings().stream().filter(sure).toList(),
                all.suppressed().stream().filter(each -> sure.test(each.finding())).toList());
    }

    /** Findings that others made: those that the models declare to be meant are told apart. */
    public static Review sort(Workspace workspace, List<Diagnostic> findings) {
        Listeners nobody = new Listeners(List.of(), Profile.REQUIREMENTS);
        Walk walk = new Walk(workspace, Profile.REQUIREMENTS, nobody);
        Walk.steps(workspace, unit -> true).forEach(step -> step.accept(walk));
        return sort(findings, walk.suppressions(), Profile.REQUIREMENTS);
    }

    /** Whether a finding is about a suppression that suppresses nothing. */
    public static boolean isUnusedSuppression(Diagnostic finding) {
        return finding.code().equals(SuppressionUsed.CODE);
    }

    private static Review sort(
            Collection<Diagnostic> found, Suppressions suppressions, Profile profile) {
        TreeSet<Diagnostic> all = new TreeSet<>(Diagnostic.ORDER);
        all.addAll(found);
        List<Diagnostic> findings = new ArrayList<>();
        List<Suppressed> suppressed = new ArrayList<>();
        for (Diagnostic finding : all) {
            List<Suppression> meant =
                    maySuppress(finding, profile) ? suppressions.covering(finding) : List.of();
            if (meant.isEmpty()) {
                findings.add(finding);
            } else {
                suppressed.add(new Suppressed(finding, meant.get(0).reason()));
            }
        }
        return new Review(findings, suppressed);
    }

    /** No code is made from a model with errors, whoever meant them. */
    private static boolean maySuppress(Diagnostic finding, Profile profile) {
        return profile == Profile.REQUIREMENTS || !finding.isError();
    }
}
