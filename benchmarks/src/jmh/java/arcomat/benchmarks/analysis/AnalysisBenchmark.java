package arcomat.benchmarks.analysis;

import arcomat.analysis.contradiction.Contradictions;
import arcomat.analysis.refinement.Refinement;
import arcomat.analysis.refinement.Verdict.Answer;
import arcomat.analysis.search.Budget;
import arcomat.semantics.Promise;

import org.openjdk.jmh.annotations.Benchmark;
import org.openjdk.jmh.annotations.BenchmarkMode;
import org.openjdk.jmh.annotations.Fork;
import org.openjdk.jmh.annotations.Measurement;
import org.openjdk.jmh.annotations.Mode;
import org.openjdk.jmh.annotations.OutputTimeUnit;
import org.openjdk.jmh.annotations.Scope;
import org.openjdk.jmh.annotations.Setup;
import org.openjdk.jmh.annotations.State;
import org.openjdk.jmh.annotations.Warmup;

import java.io.IOException;
import java.util.concurrent.TimeUnit;

/** Questions to the warm engine, from models to the answer. */
@State(Scope.Benchmark)
@BenchmarkMode(Mode.AverageTime)
@OutputTimeUnit(TimeUnit.MILLISECONDS)
@Fork(jvmArgsAppend = {"-Xmx1g", "-Xss64m"})
@Warmup(iterations = 5, time = 1)
@Measurement(iterations = 7, time = 1)
public class AnalysisBenchmark {
    private Models figures;
    private Models small;
    private Models middle;
    private Models large;
    private Models pipelines;
    private Models requirements;

    @Setup
    public void read() throws IOException {
        figures = Models.coffee();
        small = Models.of(Cases.random(20));
        middle = Models.of(Cases.random(256));
        large = Models.of(Cases.random(1_000));
        pipelines = Models.of(Cases.pipelines());
        requirements = Models.of(Texts.requirements());
    }

    @Benchmark
    public Answer figure() {
        return holds(
                figures.promise("coffee.fig6.AvoidCrash"),
                figures.promise("coffee.fig5.AvoidCrash"));
    }

    @Benchmark
    public Answer random20() {
        return holds(small.promise("load.A"), small.promise("load.B"));
    }

    @Benchmark
    public Answer random256() {
        return holds(middle.promise("load.A"), middle.promise("load.B"));
    }

    @Benchmark
    public Answer random1000() {
        return holds(large.promise("load.A"), large.promise("load.B"));
    }

    @Benchmark
    public Answer pipelineOf100() {
        return holds(pipelines.promise("load.A"), pipelines.promise("load.B"));
    }

    @Benchmark
    public Answer contradiction() {
        Promise promise = requirements.promise("load.Counters");
        Answer answer = Contradictions.check(promise, false, Budget.ofMemory()).answer();
        return required(Answer.FAILS, answer);
    }

    private static Answer holds(Promise left, Promise right) {
        Answer answer = Refinement.check(left, right, Budget.ofMemory()).answer();
        return required(Answer.HOLDS, answer);
    }

    private static Answer required(Answer wanted, Answer answer) {
        if (answer != wanted) {
            throw new IllegalStateException("the answer is " + answer);
        }
        return answer;
    }
}
