package arcomat.analysis.refinement;

import static org.assertj.core.api.Assertions.assertThat;

import arcomat.analysis.NaiveInclusion;
import arcomat.analysis.NaiveMachine;
import arcomat.analysis.NaiveShownMachine;
import arcomat.analysis.NaiveSimulation;
import arcomat.analysis.RandomNetworks;
import arcomat.analysis.RandomNetworks.Question;
import arcomat.analysis.RandomPairsTest;
import arcomat.analysis.refinement.Verdict.Answer;
import arcomat.analysis.search.Budget;
import arcomat.analysis.search.Moment;
import arcomat.model.Port;
import arcomat.model.Value;
import arcomat.semantics.Promise;
import arcomat.semantics.expression.Sent;

import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;

import java.util.HashSet;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalInt;
import java.util.Set;

/**
 * Compositions with hidden connections, feedback and parts that leave much open, against atomic
 * components and against each other: the engine beside naive enumeration, which writes every
 * message out, and every counterexample done by that.
 */
class CompositionInclusionTest {
    private static final int LENGTH = 5;

    @Tag("slow")
    @Test
    void agreesOnSomeCompositions() {
        agree(41, 25);
    }

    @Tag("slow")
    @Test
    void agreesOnFurtherCompositions() {
        agree(42, 20);
    }

    private static void agree(long seed, int count) {
        RandomNetworks random = new RandomNetworks(seed);
        int kept = 0;
        int held = 0;
        int decided = 0;
        int late = 0;
        for (int i = 0; i < count; i++) {
            Question question = random.question();
            Promise left = question.left();
            Promise right = question.right();
            Verdict verdict = Refinement.compare(left, right, Budget.ofMemory());
            OptionalInt naive = new NaiveInclusion(left, right).shortestFailure(LENGTH);
            assertThat(engine(verdict))
                    .as("seed %d, question %d: %s", seed, i, question.text())
                    .isEqualTo(naive);
            Verdict checked = Refinement.check(left, right, Budget.ofMemory());
            if (!checked.reason().equals("delay")) {
                assertThat(checked.answer())
                        .as("check, seed %d, question %d", seed, i)
                        .isEqualTo(verdict.answer());
            }
            if (verdict.answer() == Answer.FAILS) {
                int last = verdict.trace().size();
                assertThat(possible(left, right, verdict.trace()))
                        .as("left can do it")
                        .isEqualTo(last);
                assertThat(possible(right, left, verdict.trace()))
                        .as("right all but the last")
                        .isEqualTo(last - 1);
                late += last > 2 ? 1 : 0;
            } else {
                assertThat(verdict.answer()).isEqualTo(Answer.HOLDS);
                decided += isSimulationRight(verdict, left, right) ? 1 : 0;
                held++;
                kept += RandomPairsTest.isEmpty(verdict) ? 0 : 1;
            }
        }
        assertThat(kept).as("hold, not vacuously").isGreaterThan(count * 3 / 10);
        assertThat(decided).as("say whether there is a simulation").isGreaterThan(held / 2);
        assertThat(late).as("fail at length 2 or more").isGreaterThan(count / 12);
    }

    /** False where the engine does not say. */
    private static boolean isSimulationRight(Verdict verdict, Promise left, Promise right) {
        Optional<Boolean> told = verdict.simulation();
        told.ifPresent(
                simulates ->
                        assertThat(simulates)
                                .as("there is a simulation")
                                .isEqualTo(new NaiveSimulation(left, right).holds()));
        return told.isPresent();
    }

    /** The length of the counterexample, if enumeration can have found it. */
    private static OptionalInt engine(Verdict verdict) {
        int length = verdict.trace().size() - 1;
        return verdict.answer() == Answer.FAILS && length <= LENGTH
                ? OptionalInt.of(length)
                : OptionalInt.empty();
    }

    /** How many moments a side can follow. */
    private static int possible(Promise side, Promise other, List<Moment> trace) {
        List<Port> ports = side.component().outputs();
        Set<String> late = NaiveShownMachine.late(side, other, ports);
        Set<String> mixed = new HashSet<>(late);
        mixed.addAll(NaiveShownMachine.late(other, side, ports));
        NaiveMachine machine = new NaiveShownMachine(NaiveMachine.of(side), late, mixed);
        Set<Object> current = machine.starts(output(machine, trace.get(0)));
        int moments = 0;
        while (!current.isEmpty() && ++moments < trace.size()) {
            Moment moment = trace.get(moments);
            Map<String, Value> input = new LinkedHashMap<>();
            for (Port port : machine.component().inputs()) {
                input.put(port.name(), moment.input().message(port.name()).orElse(null));
            }
            Set<Object> next = new HashSet<>();
            for (Object each : current) {
                next.addAll(machine.after(each, input, output(machine, moment)));
            }
            current = next;
        }
        return moments;
    }

    /** What a moment says about the outputs of a side; what it leaves open is left aside. */
    private static Map<String, Value> output(NaiveMachine machine, Moment moment) {
        Map<String, Value> output = new LinkedHashMap<>();
        if (moment.error()) {
            output.putAll(NaiveMachine.ERROR);
        }
        for (Port port : machine.component().outputs()) {
            if (moment.outputs().get(port.name()) instanceof Sent.Messages sent) {
                output.put(port.name(), sent.values().isEmpty() ? null : sent.values().get(0));
            }
        }
        return output;
    }
}
