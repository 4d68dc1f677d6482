package arcomat.check;

import arcomat.source.Diagnostic;
import arcomat.symbols.Workspace;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.TreeSet;

/** The list of all context conditions, and the one way to run them. */
public final class Checks {
    /** One line per law, in alphabetical order. */
    static final List<Check> ALL =
            List.of(
                    new ComponentNameIsFileName(),
                    new DefaultParametersLast(),
                    new FileNamesDifferInCaseOnly(),
                    new ImportUnique(),
                    new JavaPartUnsupported(),
                    new PackageIsFolder(),
                    new PortNameUncapitalised(),
                    new StereotypeInPlace(),
                    new StereotypeKnown(),
                    new StereotypeValue(),
                    new SuppressWellFormed(),
                    new TopLevelComponentWithoutInstance(),
                    new TypeNameCapitalised(),
                    new TypeParametersUnique());

    private Checks() {}

    /** The findings about all files of a workspace, ordered, each once. */
    public static List<Diagnostic> run(Workspace workspace, Profile profile) {
        return review(workspace, profile).findings();
    }

    /** The findings, and those that the models declare to be meant. */
    public static Review review(Workspace workspace, Profile profile) {
        Listeners listeners = new Listeners(ALL, profile);
        Suppressions suppressions = new Suppressions();
        new Walk(workspace, profile, listeners, suppressions).walk();
        return sort(listeners, suppressions, profile);
    }

    private static Review sort(Listeners listeners, Suppressions suppressions, Profile profile) {
        TreeSet<Diagnostic> all = new TreeSet<>(Diagnostic.ORDER);
        for (Findings findings : listeners.findings()) {
            all.addAll(findings.diagnostics());
        }
        List<Diagnostic> findings = new ArrayList<>();
        List<Review.Suppressed> suppressed = new ArrayList<>();
        for (Diagnostic finding : all) {
            Optional<String> reason =
                    maySuppress(finding, profile) ? suppressions.reason(finding) : Optional.empty();
            if (reason.isPresent()) {
                suppressed.add(new Review.Suppressed(finding, reason.get()));
            } else {
                findings.add(finding);
            }
        }
        return new Review(findings, suppressed);
    }

    /** No code is made from a model with errors, whoever meant them. */
    private static boolean maySuppress(Diagnostic finding, Profile profile) {
        return profile == Profile.REQUIREMENTS || !finding.isError();
    }
}
