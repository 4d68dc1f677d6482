package arcomat.analysis.automaton;

import static org.assertj.core.api.Assertions.assertThat;

import arcomat.analysis.automaton.exploration.Exploration;
import arcomat.analysis.automaton.exploration.Knowledge;
import arcomat.analysis.automaton.exploration.Solving;
import arcomat.analysis.reachability.RunProperty;
import arcomat.analysis.reachability.Subject;
import arcomat.analysis.search.Budget;
import arcomat.model.Automaton;
import arcomat.model.Component;
import arcomat.model.Value;
import arcomat.models.ReadModels;
import arcomat.source.SourceFile;

import org.junit.jupiter.api.Assumptions;
import org.junit.jupiter.api.DynamicTest;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.TestFactory;

import java.util.ArrayList;
import java.util.EnumMap;
import java.util.List;
import java.util.Map;
import java.util.stream.Stream;

/**
 * A transition that is called dead is taken in no run, and an integer wraps around only where that
 * is told; asked of Z3 with vectors of 32 bits, and 64, and floating point.
 */
class DeadTransitionsTest {
    private static final int MODELS = 8;
    private static final int STEPS = 2;

    /** What has no end is soon left to the solver. */
    private static final Budget BUDGET = Budget.ofMemory().atMost(500);

    /** What is said of a transition. */
    enum Kind {
        DEAD,
        ALIVE,
        OPEN
    }

    @Tag("slow")
    @TestFactory
    Stream<DynamicTest> noRunTakesThem() {
        if (!InstalledZ3.isThere()) {
            return Stream.of(
                    DynamicTest.dynamicTest(
                            "skipped: there is no program 'z3' on this machine",
                            () -> Assumptions.abort("no program 'z3'")));
        }
        return Stream.of(
                DynamicTest.dynamicTest("in one step", () -> inOneStep(1, MODELS)),
                DynamicTest.dynamicTest("with a memory", () -> withMemory(1, MODELS / 8)));
    }

    /** Where nothing is remembered, one step tells all. */
    static void inOneStep(long seed, int models) {
        Map<Kind, Integer> seen = new EnumMap<>(Kind.class);
        for (long each = seed; each < seed + models; each++) {
            compare(each, false, 0, seen);
        }
        assertThat(seen.getOrDefault(Kind.DEAD, 0)).as("dead").isGreaterThan(models / 3);
        assertThat(seen.getOrDefault(Kind.ALIVE, 0)).as("alive").isGreaterThan(models / 2);
    }

    static void withMemory(long seed, int models) {
        Map<Kind, Integer> seen = new EnumMap<>(Kind.class);
        for (long each = seed; each < seed + models; each++) {
            compare(each, true, STEPS, seen);
        }
        assertThat(seen.getOrDefault(Kind.DEAD, 0)).as("dead").isGreaterThan(models / 4);
    }

    private static void compare(long seed, boolean remembers, int steps, Map<Kind, Integer> seen) {
        String text = new RandomArithmetic(seed, remembers).text();
        Component component =
                ReadModels.model(new SourceFile("Random.arc", text)).components().get(0);
        Automaton automaton = ((Component.Atomic) component.body()).automata().get(0);
        List<Value> arguments = List.of(new Value.IntegerValue(Integer.MAX_VALUE - seed % 3));
        Subject subject = Subject.of(component, automaton, arguments);
        Knowledge known = known(subject);
        List<String> answers =
                InstalledZ3.answers(
                        script(new BitVectors(component, automaton, arguments), automaton, steps));
        int transitions = automaton.transitions().size();
        assertThat(answers).as(text).hasSize(2 * transitions);
        for (int i = 0; i < transitions; i++) {
            String about = "seed " + seed + ", transition " + i + " of\n" + text;
            Kind taken = kind(new RunProperty.Enabled(i), known);
            compare("taken", taken, answers.get(2 * i), !remembers, about);
            Kind wraps =
                    subject.preconditions().get(i).mayWrap()
                            ? kind(new RunProperty.Overflow(i), known)
                            : Kind.DEAD;
            compare("wraps", wraps, answers.get(2 * i + 1), !remembers, about);
            seen.merge(taken, 1, Integer::sum);
        }
    }

    private static Knowledge known(Subject subject) {
        Exploration explored = new Exploration(subject, situation -> {}, BUDGET);
        explored.run();
        return new Solving(subject, situation -> {}, BUDGET).after(explored);
    }

    private static Kind kind(RunProperty question, Knowledge known) {
        if (known.happens(question)) {
            return Kind.ALIVE;
        }
        return known.neverHappens(question) ? Kind.DEAD : Kind.OPEN;
    }

    /**
     * @param all whether Z3 was asked about all runs
     */
    private static void compare(String what, Kind kind, String answer, boolean all, String about) {
        assertThat(answer).as(about).isIn("sat", "unsat", "unknown");
        if (kind == Kind.DEAD) {
            assertThat(answer).as(what + "? " + about).isNotEqualTo("sat");
        } else if (kind == Kind.ALIVE && all) {
            assertThat(answer).as("never " + what + "? " + about).isNotEqualTo("unsat");
        }
    }

    /** Asks of each transition whether it can be taken, and whether an integer wraps around. */
    private static List<String> script(BitVectors vectors, Automaton automaton, int steps) {
        List<String> script = new ArrayList<>();
        int transitions = automaton.transitions().size();
        for (int step = 0; step <= steps; step++) {
            script.addAll(vectors.step(step));
        }
        script.add("(assert " + vectors.beginning() + ")");
        // A run may end before the last step.
        for (int step = 0; step < steps; step++) {
            StringBuilder any = new StringBuilder("(or (= state@" + (step + 1) + " -1)");
            for (int i = 0; i < transitions; i++) {
                any.append(' ').append(vectors.goes(i, step));
            }
            script.add("(assert " + any + "))");
        }
        for (int i = 0; i < transitions; i++) {
            List<String> taken = new ArrayList<>();
            List<String> wraps = new ArrayList<>();
            for (int step = 0; step <= steps; step++) {
                taken.add(vectors.enabled(i, step));
                wraps.add(vectors.wraps(i, step));
            }
            ask(taken, script);
            ask(wraps, script);
        }
        return script;
    }

    private static void ask(List<String> any, List<String> script) {
        script.add("(push)");
        script.add("(assert (or " + String.join(" ", any) + "))");
        script.add("(check-sat)");
        script.add("(pop)");
    }
}
