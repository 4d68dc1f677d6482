package arcomat.benchmarks.data;

import arcomat.analysis.refinement.Refinement;
import arcomat.analysis.refinement.Verdict;
import arcomat.analysis.search.Budget;
import arcomat.benchmarks.measure.LoweredSources;
import arcomat.model.Model;
import arcomat.semantics.Promise;

import java.util.ArrayList;
import java.util.List;

/** A question asked in a process of its own, once or again and again: {@code again gaps 20}. */
public final class AskedQuestion {
    /** So long it is asked until Java knows the code, in nanoseconds, and once more as long. */
    private static final long WARM = 3_000_000_000L;

    private static final double MILLION = 1e6;

    /** Behind the answer: the median of the later times in milliseconds, and how many these are. */
    static final String AGAIN = "again";

    /** Nothing but the answer. */
    static final String ONCE = "once";

    private AskedQuestion() {}

    /** Prints the answer. */
    public static void main(String[] arguments) {
        DataQuestion question = DataQuestions.of(arguments[1] + " " + arguments[2]);
        Verdict verdict = ask(question);
        if (arguments[0].equals(ONCE)) {
            System.out.println(verdict.answer());
            return;
        }
        repeated(question);
        List<Double> times = repeated(question);
        System.out.printf(
                "%s %.4f %d%n", verdict.answer(), times.get(times.size() / 2), times.size());
    }

    private static List<Double> repeated(DataQuestion question) {
        List<Double> times = new ArrayList<>();
        long begin = System.nanoTime();
        do {
            long start = System.nanoTime();
            ask(question);
            times.add((System.nanoTime() - start) / MILLION);
        } while (System.nanoTime() - begin < WARM);
        return times.stream().sorted().toList();
    }

    /** From the text on: a solver reads its own as well. */
    private static Verdict ask(DataQuestion question) {
        Model model = LoweredSources.of("asked", question.models());
        Promise left = Promise.of(model.component("Left").orElseThrow(), List.of());
        Promise right = Promise.of(model.component("Right").orElseThrow(), List.of());
        return Refinement.check(left, right, new Budget(() -> false, 100_000));
    }
}
