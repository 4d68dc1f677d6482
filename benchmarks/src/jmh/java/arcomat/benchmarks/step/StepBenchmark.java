package arcomat.benchmarks.step;

import coffee.fig6.logic.AvoidCrash;

import org.openjdk.jmh.annotations.Benchmark;
import org.openjdk.jmh.annotations.BenchmarkMode;
import org.openjdk.jmh.annotations.Measurement;
import org.openjdk.jmh.annotations.Mode;
import org.openjdk.jmh.annotations.OperationsPerInvocation;
import org.openjdk.jmh.annotations.OutputTimeUnit;
import org.openjdk.jmh.annotations.Param;
import org.openjdk.jmh.annotations.Scope;
import org.openjdk.jmh.annotations.Setup;
import org.openjdk.jmh.annotations.State;
import org.openjdk.jmh.annotations.Warmup;

import java.util.concurrent.TimeUnit;

/** One step of Fig. 6, on a busy and on a sparse stream. */
@State(Scope.Thread)
@BenchmarkMode(Mode.AverageTime)
@OutputTimeUnit(TimeUnit.NANOSECONDS)
@OperationsPerInvocation(Letters.COUNT)
@Warmup(iterations = 4, time = 500, timeUnit = TimeUnit.MILLISECONDS)
@Measurement(iterations = 7, time = 300, timeUnit = TimeUnit.MILLISECONDS)
public class StepBenchmark {
    /** How often a port carries a message. */
    @Param({"0.9", "0.05"})
    double density;

    private Letters letters;
    private EnumLetters enumLetters;

    private final AvoidCrash generated = new AvoidCrash();
    private final IntSwitch intSwitch = new IntSwitch();
    private final EnumSwitch enumSwitch = new EnumSwitch();
    private final StatelessMachine stateless = new StatelessMachine();
    private final SquirrelMachine squirrel = new SquirrelMachine();
    private final SpringMachine spring = new SpringMachine();
    private final ScxmlMachine scxml = new ScxmlMachine();

    @Setup
    public void draw() {
        letters = new Letters(density);
        enumLetters = new EnumLetters(letters);
    }

    @Benchmark
    public int generated() {
        return Contestants.run(generated, letters);
    }

    @Benchmark
    public int intSwitch() {
        return Contestants.run(intSwitch, letters);
    }

    @Benchmark
    public int enumSwitch() {
        return Contestants.run(enumSwitch, enumLetters);
    }

    @Benchmark
    public int stateless4j() {
        return Contestants.run(stateless, letters);
    }

    @Benchmark
    public int squirrel() {
        return Contestants.run(squirrel, letters);
    }

    @Benchmark
    public int spring() {
        return Contestants.run(spring, letters);
    }

    @Benchmark
    public int scxml() {
        return Contestants.run(scxml, letters);
    }
}
