package arcomat.pipeline.watch;

import arcomat.analysis.refinement.Answered;
import arcomat.pipeline.Interruption;
import arcomat.pipeline.Session;
import arcomat.pipeline.WrongUse;
import arcomat.pipeline.analysis.AnalysisLimits;
import arcomat.pipeline.check.CheckedAnswer;
import arcomat.pipeline.file.FileReader;
import arcomat.pipeline.recheck.Dependencies;
import arcomat.pipeline.world.PrepareWorld;
import arcomat.pipeline.world.PreparedWorld;
import arcomat.sim.time.OutOfPatience;
import arcomat.simulate.test.StreamTestResult;
import arcomat.source.Diagnostic;

import java.util.Collection;
import java.util.HashSet;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.concurrent.CancellationException;

/**
 * What is asked after a check: tests, promises, worlds, as far as a change touches them. It ends
 * when a newer save comes, and what it had not answered is asked again then.
 */
record SlowSteps(
        Blackboard board,
        Dependencies files,
        Session session,
        AnalysisLimits limits,
        Interruption interruption)
        implements Runnable {
    /** A world is run as its author would run it first. */
    private static final long SEED = 1;

    @Override
    public void run() {
        try {
            test(session);
            verify(session);
            for (String world : board.worlds().stream().sorted().toList()) {
                long begun = System.nanoTime();
                board.ended(run(world, session), System.nanoTime() - begun, interruption);
            }
            board.settled(interruption);
        } catch (CancellationException newer) {
            // The next round asks again.
        } catch (WrongUse | RuntimeException | StackOverflowError | OutOfMemoryError error) {
            board.failed(error, interruption);
        }
    }

    private void test(Session session) throws WrongUse {
        long begun = System.nanoTime();
        Set<String> suites = board.suites(files);
        if (suites.isEmpty()) {
            board.tested(suites, List.of(), Set.of(), 0, interruption);
            return;
        }
        CheckedAnswer<List<StreamTestResult>> reply =
                session.run(new RunSuites(named(files.neededBy(suites)), suites));
        board.tested(
                suites,
                reply.value().orElse(List.of()),
                unanswered(suites, reply),
                System.nanoTime() - begun,
                interruption);
    }

    private void verify(Session session) throws WrongUse {
        long begun = System.nanoTime();
        Set<String> scope = board.scope(files);
        if (scope.isEmpty()) {
            board.shown(scope, List.of(), Set.of(), 0, interruption);
            return;
        }
        CheckedAnswer<List<Answered>> reply =
                session.run(
                        new ShowPromises(
                                named(scope), limits.budget().endingWhen(interruption::isEnded)));
        board.shown(
                scope,
                reply.value().orElse(List.of()),
                unanswered(scope, reply),
                System.nanoTime() - begun,
                interruption);
    }

    /** Files about which nothing was said, because there are errors. */
    private static Set<String> unanswered(Set<String> asked, CheckedAnswer<?> reply) {
        Set<String> unanswered = new HashSet<>(asked);
        if (reply.value().isPresent()) {
            unanswered.retainAll(reply.check().aside().files());
        }
        return unanswered;
    }

    private List<String> named(Collection<String> paths) {
        Set<String> named = files.named();
        return paths.stream().filter(named::contains).sorted().toList();
    }

    /** What is said about watched models has been said by the check. */
    private List<Diagnostic> besideModels(List<Diagnostic> findings) {
        Set<String> models = files.named();
        return findings.stream()
                .filter(each -> !models.contains(each.span().file().path()))
                .toList();
    }

    private WorldEnd run(String world, Session session) {
        try {
            FileReader.required("world", world, session.names());
            PreparedWorld prepared = session.run(new PrepareWorld(world, false));
            interruption.goOn();
            return new WorldEnd(
                    world,
                    prepared.canRun() ? Optional.of(prepared.run(SEED)) : Optional.empty(),
                    besideModels(prepared.findings()),
                    Optional.empty());
        } catch (WrongUse | OutOfPatience reason) {
            return new WorldEnd(
                    world,
                    Optional.empty(),
                    List.of(),
                    Optional.of(String.valueOf(reason.getMessage())));
        }
    }
}
