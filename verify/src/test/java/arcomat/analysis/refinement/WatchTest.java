package arcomat.analysis.refinement;

import static org.assertj.core.api.Assertions.assertThat;

import arcomat.analysis.RandomNetworks;
import arcomat.analysis.RandomPairs;
import arcomat.analysis.RandomPairs.Pair;
import arcomat.analysis.refinement.Verdict.Answer;
import arcomat.analysis.search.Budget;
import arcomat.model.Automaton;
import arcomat.model.Component;
import arcomat.model.Model;
import arcomat.model.Port;
import arcomat.model.Trace;
import arcomat.pipeline.compile.CompiledMonitor;
import arcomat.semantics.Promise;
import arcomat.simulate.run.Choice;
import arcomat.simulate.run.Interpreter;
import arcomat.simulate.run.Simulation;
import arcomat.simulate.watch.Watch;
import arcomat.simulate.watch.Watch.Violation;
import arcomat.simulate.watch.Watching;
import arcomat.simulate.watch.Watching.Watched;

import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.stream.Collectors;

/**
 * Watching and proving agree: runs of what refines a requirement keep it, and a counterexample
 * violates it where its last step is seen, not before. Generated monitors say the same.
 */
class WatchTest {
    private static final int PAIRS = Integer.getInteger("watch.pairs", 200);
    private static final int SEED = Integer.getInteger("watch.seed", 11);
    private static final int RUNS = 4;

    /** Of so many pairs one is compiled. */
    private static final int EVERY = Integer.getInteger("watch.every", 20);

    private static final Budget BUDGET = new Budget(() -> false, 20_000);

    private int held;
    private int failed;
    private int errors;
    private int mixed;

    @Test
    void agreesWithRefinement() {
        int number = 0;
        for (Pair pair : RandomPairs.any(SEED, PAIRS)) {
            compare(pair.left(), pair.right(), SEED + number++, pair.toString(), false);
        }
        enough();
    }

    @Test
    void agreesForConjunctions() {
        int number = 0;
        for (RandomPairs.Question pair : RandomPairs.conjunctions(SEED, PAIRS)) {
            compare(pair.left(), pair.right(), SEED + number++, pair.toString(), false);
        }
        enough();
    }

    @Tag("slow")
    @Test
    void agreesForCompositions() {
        RandomNetworks networks = new RandomNetworks(SEED);
        for (int i = 0; i < PAIRS; i++) {
            RandomNetworks.Question question = networks.question();
            if (!question.right().isComposition()) {
                compare(question.left(), question.right(), SEED + i, question.text(), false);
            }
        }
        enough();
    }

    @Tag("slow")
    @Test
    void agreesForAllSorts() {
        for (int i = 0; i < PAIRS; i++) {
            RandomWatched watched = new RandomWatched(SEED + i);
            Model model = watched.model();
            Promise left = Promise.of(RandomWatched.component(model, "Running"), List.of());
            Promise right = Promise.of(RandomWatched.component(model, "Required"), List.of());
            compare(left, right, SEED + i, watched.text(), i % EVERY == 0);
        }
        enough();
        assertThat(errors).isGreaterThan(PAIRS / 40);
        assertThat(mixed).isGreaterThan(PAIRS / 10);
    }

    private void enough() {
        assertThat(held).isGreaterThan(PAIRS / 10);
        assertThat(failed).isGreaterThan(PAIRS / 5);
    }

    private void compare(Promise left, Promise right, int seed, String text, boolean compiled) {
        Component running = left.component();
        Component required = right.component();
        boolean same = sameDelays(running, required);
        if (!same) {
            mixed++;
        }
        List<Trace> runs = new ArrayList<>();
        Verdict verdict = Refinement.check(left, right, BUDGET);
        if (verdict.answer() == Answer.HOLDS) {
            held++;
        } else if (!verdict.trace().isEmpty()) {
            failed++;
            Trace run = CounterexampleRun.of(running, required, verdict.trace());
            errors += run.end().isPresent() ? 1 : 0;
            Optional<Violation> found = violation(required, running, run);
            assertThat(found).as(() -> text(text, run, found)).isPresent();
            assertThat(found.get().slice())
                    .as(() -> text(text, run, found))
                    .isIn(seen(running, required, run));
            runs.add(run);
        }
        for (int i = 0; i < RUNS; i++) {
            Trace run = run(running, seed + i);
            runs.add(run);
            Optional<Violation> found = violation(required, running, run);
            if (verdict.answer() == Answer.HOLDS && !errsAfterChaos(run)) {
                assertThat(found).as(() -> text(text, run, found)).isEmpty();
            }
        }
        if (compiled) {
            CompiledMonitor monitor = CompiledMonitor.of(required);
            for (Trace run : runs) {
                compare(monitor, required, running, run, text);
            }
        }
    }

    /** The first word of all automata, or of the one that said it. */
    private static void compare(
            CompiledMonitor monitor,
            Component required,
            Component running,
            Trace run,
            String text) {
        List<Watched> watched = watched(required, running, run);
        int first =
                watched.stream()
                        .flatMap(each -> each.violation().stream())
                        .mapToInt(Violation::slice)
                        .min()
                        .orElse(-1);
        String said =
                watched.stream()
                        .flatMap(each -> each.violation().stream())
                        .filter(violation -> violation.slice() == first)
                        .map(Violation::message)
                        .collect(Collectors.joining("\n"));
        CompiledMonitor.Word word = monitor.watch(List.of(), run);
        assertThat(numbered(word.violation(), required))
                .as(() -> text(text, run, ""))
                .isEqualTo(numbered(said, required));
    }

    /** Generated monitors are not told of latched ports that change without an event. */
    private static String numbered(String said, Component required) {
        return required.profile() == Component.Profile.EVENT_DRIVEN
                ? said.replaceAll("event \\d+", "event")
                : said;
    }

    private static boolean sameDelays(Component running, Component required) {
        return required.outputs().stream()
                .allMatch(
                        port ->
                                port.delay()
                                        == 1
                                        == CounterexampleRun.late(running).contains(port.name()));
    }

    /**
     * The slices in which the last step of a counterexample may be seen: its reaction in the slice
     * before the last, or in the last one where it is late on both sides. That the right side had
     * to end is seen where it shows nothing any more.
     */
    private static List<Integer> seen(Component running, Component required, Trace run) {
        int last = run.steps().size() - 1;
        if (run.end().isPresent()) {
            return List.of(last + 1);
        }
        if (required.profile() == Component.Profile.EVENT_DRIVEN) {
            return List.of(Math.max(0, last));
        }
        Set<String> late = CounterexampleRun.late(running);
        List<Port> outputs = required.outputs();
        if (outputs.stream().allMatch(port -> port.delay() == 1 && late.contains(port.name()))) {
            return List.of(last);
        }
        return outputs.stream().allMatch(port -> port.delay() == 0)
                ? List.of(last - 1)
                : List.of(last - 1, last);
    }

    private static String text(String models, Trace run, Object found) {
        StringBuilder text = new StringBuilder(models);
        run.opening().ifPresent(opening -> text.append("\nopening " + opening));
        for (Trace.Step step : run.steps()) {
            text.append("\n" + step.number() + " " + step.inputs() + " / " + step.outputs());
        }
        run.end().ifPresent(end -> text.append("\n" + end));
        return text.append("\n" + run.failure() + found).toString();
    }

    /**
     * A run stays where it is after chaos, and may go wrong there; chaos allows everything else.
     */
    private static boolean errsAfterChaos(Trace run) {
        Trace.Cause chaos = new Trace.Completed(Automaton.Completion.CHAOS);
        return run.end().isPresent()
                && run.steps().stream()
                        .flatMap(step -> step.activities().stream())
                        .anyMatch(activity -> activity.cause().equals(chaos));
    }

    private static Optional<Violation> violation(Component required, Component running, Trace run) {
        return watched(required, running, run).stream()
                .flatMap(watched -> watched.violation().stream())
                .min(Comparator.comparingInt(Violation::slice));
    }

    private static List<Watched> watched(Component required, Component running, Trace run) {
        List<Watch> watches =
                required.automata().stream()
                        .map(a -> new Watch(required, a, List.of(), running))
                        .toList();
        return Watching.all(watches, run);
    }

    private static Trace run(Component component, int seed) {
        Interpreter interpreter =
                new Interpreter(component, List.of(), Choice.randomThroughout(seed));
        return Simulation.run(
                interpreter, Simulation.drawn(interpreter.network(), seed, 60).limit(16).toList());
    }
}
