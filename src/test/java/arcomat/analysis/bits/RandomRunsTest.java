package arcomat.analysis.bits;

import static org.assertj.core.api.Assertions.assertThat;

import arcomat.analysis.refinement.RandomQuestion;
import arcomat.analysis.refinement.Sides;
import arcomat.analysis.refinement.Verdict.Answer;
import arcomat.analysis.search.Budget;
import arcomat.model.Letter;
import arcomat.model.Port;
import arcomat.model.Type;
import arcomat.model.Value;
import arcomat.semantics.automaton.ComponentSemantics;
import arcomat.semantics.automaton.ComponentSemantics.JointReaction;
import arcomat.semantics.automaton.ComponentSemantics.JointStart;
import arcomat.semantics.automaton.Configuration;
import arcomat.semantics.automaton.Input;

import org.junit.jupiter.api.Test;

import java.util.LinkedHashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Random;
import java.util.Set;
import java.util.stream.Collectors;

/**
 * What is said to hold of Doubles, holds in runs: whatever the left side sends on random messages,
 * the right one may send. Only the step relation is asked.
 */
class RandomRunsTest {
    private static final int QUESTIONS = 12;
    private static final int FIRST = 1_000;
    private static final int RUNS = 60;
    private static final int SLICES = 30;
    private static final double[] NOTABLE = {
        0,
        -0.0,
        0.5,
        1,
        0.1,
        2,
        1.5,
        10,
        3,
        -0.5,
        -1,
        1e17,
        0x1p31,
        0x1p53,
        Double.MIN_VALUE,
        Double.MAX_VALUE,
        Double.POSITIVE_INFINITY,
        Double.NEGATIVE_INFINITY,
        Double.NaN
    };

    @Test
    void whatHoldsHoldsInRuns() {
        int holds = 0;
        for (int seed = FIRST; seed < FIRST + QUESTIONS; seed++) {
            List<String> texts = new RandomQuestion(seed, true).models();
            Sides sides = Sides.of(texts);
            if (sides.check(new Budget(() -> false, 10_000)).answer() == Answer.HOLDS) {
                holds++;
                for (int run = 0; run < RUNS; run++) {
                    follow(sides, new Random(run), "seed " + seed + ": " + texts);
                }
            }
        }
        assertThat(holds).isGreaterThan(QUESTIONS / 4);
    }

    private static void follow(Sides sides, Random random, String about) {
        ComponentSemantics left = sides.left().behaviour();
        ComponentSemantics right = sides.right().behaviour();
        List<Configuration> mine = left.starts().get(0).configurations();
        Set<List<Configuration>> theirs =
                right.starts().stream().map(JointStart::configurations).collect(Collectors.toSet());
        for (int slice = 0; slice < SLICES; slice++) {
            Letter letter = letter(left.component().inputs(), random);
            List<JointReaction> all =
                    left.prospect(mine, Input.of(left.component(), letter)).reactions();
            JointReaction reaction = all.get(random.nextInt(all.size()));
            Set<List<Configuration>> next = new LinkedHashSet<>();
            for (List<Configuration> each : theirs) {
                right.prospect(each, Input.of(right.component(), letter)).reactions().stream()
                        .filter(other -> other.output().equals(reaction.output()))
                        .forEach(other -> next.add(other.next()));
            }
            assertThat(next).as("%s%n%s sends %s", about, letter, reaction.output()).isNotEmpty();
            mine = reaction.next();
            theirs = next;
        }
    }

    private static Letter letter(List<Port> ports, Random random) {
        Map<String, List<Value>> messages = new LinkedHashMap<>();
        ports.forEach(port -> messages.put(port.name(), List.of(message(port.type(), random))));
        return new Letter(messages);
    }

    private static Value message(Type type, Random random) {
        if (type instanceof Type.RealType) {
            return new Value.RealValue(real(random));
        }
        return type instanceof Type.StringType
                ? new Value.StringValue(random.nextBoolean() ? "a" : "b")
                : new Value.IntegerValue((int) real(random));
    }

    /** A number that matters, or one next to it, or any. */
    private static double real(Random random) {
        double number = NOTABLE[random.nextInt(NOTABLE.length)];
        return switch (random.nextInt(4)) {
            case 0 -> Double.longBitsToDouble(random.nextLong());
            case 1 -> random.nextBoolean() ? Math.nextUp(number) : Math.nextDown(number);
            default -> number;
        };
    }
}
