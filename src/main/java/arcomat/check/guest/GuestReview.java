package arcomat.check.guest;

import arcomat.check.law.Check.Findings;
import arcomat.check.law.Law;
import arcomat.check.law.Profile;
import arcomat.check.walk.Listeners;
import arcomat.check.walk.Walk;
import arcomat.source.Diagnostic;
import arcomat.source.Span;
import arcomat.symbols.Workspace;
import arcomat.tree.Unit;

import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.TimeoutException;
import java.util.function.Consumer;
import java.util.function.Predicate;

/**
 * One guest's laws, asked about a workspace: in a walk and a thread of their own, so that nothing
 * that happens there touches what the tool itself finds.
 *
 * @param limit after which the guest is left alone
 */
public record GuestReview(GuestLaws guest, Duration limit) {
    /**
     * What came of it.
     *
     * @param findings of the laws, and what went wrong in them
     * @param whole whether every law has seen everything
     */
    public record Outcome(List<Diagnostic> findings, boolean whole) {}

    /**
     * The findings, each with the name of the guest.
     *
     * @param wanted files to look at
     * @param goOn asked before each step; what it throws ends the work
     */
    public Outcome run(
            Workspace workspace, Profile profile, Predicate<Unit> wanted, Runnable goOn) {
        if (workspace.units().isEmpty()) {
            return new Outcome(List.of(), true);
        }
        try {
            return new GuestThread(guest.guest(), limit)
                    .call(() -> walk(workspace, profile, wanted, goOn));
        } catch (TimeoutException e) {
            return tooLong(workspace);
        } catch (ExecutionException e) {
            throw unchecked(e.getCause() == null ? e : e.getCause());
        }
    }

    private Outcome walk(
            Workspace workspace, Profile profile, Predicate<Unit> wanted, Runnable goOn) {
        List<Diagnostic> failures = new ArrayList<>();
        List<Law> guarded =
                guest.laws().stream()
                        .map(
                                law ->
                                        GuardedCheck.around(
                                                law, (l, at, e) -> failures.add(failed(l, at, e))))
                        .toList();
        Walk walk = new Walk(workspace, profile, new Listeners(guarded, profile));
        for (Consumer<Walk> step : Walk.steps(workspace, wanted)) {
            goOn.run();
            if (Thread.interrupted()) {
                break; // nobody waits any more
            }
            step.accept(walk);
        }
        List<Diagnostic> all = new ArrayList<>();
        for (Findings each : walk.findings()) {
            each.diagnostics().forEach(finding -> all.add(named(finding)));
        }
        all.addAll(failures);
        return new Outcome(all, failures.isEmpty());
    }

    /** Whoever reads a finding has to know whom to ask about it. */
    private Diagnostic named(Diagnostic finding) {
        return finding.withMessage(finding.message() + " (guest '" + guest.guest() + "')");
    }

    private Diagnostic failed(Law law, Span place, Throwable thrown) {
        return new GuestFailure(guest.guest()).lawFailed(law.code(), place, thrown);
    }

    private Outcome tooLong(Workspace workspace) {
        Span beginning = workspace.units().get(0).file().span(0, 0);
        return new Outcome(
                List.of(new GuestFailure(guest.guest()).tooLong("laws", beginning, limit)), false);
    }

    /** What ends the work of the tool, and not of the guest. */
    private static RuntimeException unchecked(Throwable thrown) {
        if (thrown instanceof Error error) {
            throw error;
        }
        return thrown instanceof RuntimeException known ? known : new IllegalStateException(thrown);
    }
}
