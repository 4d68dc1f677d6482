package arcomat.laws;

import arcomat.analysis.refinement.Verdict;
import arcomat.laws.draw.Draw;
import arcomat.model.Automaton.Completion;
import arcomat.model.Component;
import arcomat.model.Letter;
import arcomat.model.StreamTest;
import arcomat.model.Trace;
import arcomat.simulate.run.Choice;
import arcomat.simulate.run.Interpreter;
import arcomat.simulate.run.Simulation;
import arcomat.simulate.test.StreamTestResult;
import arcomat.simulate.test.StreamTests;
import arcomat.simulate.watch.Watching.Watched;
import arcomat.source.SourceFile;

import java.util.List;
import java.util.Optional;

/** Where it holds, no run of the left side is rejected by the right one's test or monitor. */
final class RunsAreAllowed implements Law {
    private static final int SLICES = 12;
    private static final int RUNS = 4;

    @Override
    public String name() {
        return "1 runs are allowed";
    }

    @Override
    public List<SourceFile> draw(Draw draw) {
        return Pairs.draw(draw);
    }

    @Override
    public Outcome check(Models models) {
        Component left = models.component(Pairs.LEFT);
        Component right = models.component(Pairs.RIGHT);
        Verdict verdict = Questions.refines(left, right);
        if (!Questions.holds(verdict)) {
            return Outcome.SKIPPED;
        }
        for (int i = 0; i < RUNS; i++) {
            Outcome outcome = check(left, right, models.seed() + i);
            if (outcome.isBroken()) {
                return outcome;
            }
        }
        return Outcome.KEPT;
    }

    /** Whether there are events that a test of the right side cannot tell. */
    private static boolean isUnseen(Component left, Component right) {
        return left.profile() == Component.Profile.EVENT_DRIVEN
                && left.inputs().stream().anyMatch(p -> right.port(p.name()).isEmpty());
    }

    static Trace run(Component component, int seed, int slices) {
        Choice choice = seed % 2 == 0 ? Choice.random(seed) : Choice.randomThroughout(seed);
        Interpreter interpreter = new Interpreter(component, List.of(), choice);
        List<Letter> letters =
                Simulation.drawn(interpreter.network(), seed, 60).limit(slices).toList();
        return Simulation.run(interpreter, letters);
    }

    /**
     * Who runs on in chaos stays where it was, and may go wrong there; that is nobody's promise.
     */
    private static Trace withoutErrorAfterChaos(Trace run) {
        boolean chaos =
                run.steps().stream()
                        .flatMap(step -> step.activities().stream())
                        .anyMatch(a -> a.cause().equals(new Trace.Completed(Completion.CHAOS)));
        Optional<Trace.End> noEnd = Optional.empty();
        return chaos
                ? new Trace(run.component(), run.steps(), Optional.empty(), run.opening(), noEnd)
                : run;
    }

    private static Outcome check(Component left, Component right, int seed) {
        Trace run = withoutErrorAfterChaos(run(left, seed, SLICES));
        if (run.steps().isEmpty()) {
            return Outcome.KEPT;
        }
        StreamTest test = Recorded.test(right, run);
        String refines = Questions.command(Pairs.LEFT, Pairs.RIGHT) + ": holds";
        String path = Recorded.path(right);
        if (!isUnseen(left, right)
                && StreamTests.run(test).verdict() == StreamTestResult.Verdict.FAILED) {
            return Outcome.broken(
                            "a run of the left side is rejected by test on the right one",
                            refines,
                            "test " + path + ": fails")
                    .with(path, Recorded.text(test));
        }
        if (right.isComposite()) {
            return Outcome.KEPT;
        }
        for (Watched each : Questions.watched(right, left, run)) {
            if (each.violation().isPresent()) {
                return Outcome.broken(
                                "a run of the left side is rejected by the right one's monitor: "
                                        + each.violation().get().message(),
                                refines,
                                "simulate --monitor " + Pairs.RIGHT + " --input " + path)
                        .with(path, Recorded.text(test));
            }
        }
        return Outcome.KEPT;
    }
}
