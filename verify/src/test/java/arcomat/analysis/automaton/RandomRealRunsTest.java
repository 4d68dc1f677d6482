package arcomat.analysis.automaton;

import static org.assertj.core.api.Assertions.assertThat;

import arcomat.analysis.automaton.exploration.RunProperties;
import arcomat.analysis.automaton.exploration.Situation;
import arcomat.analysis.automaton.exploration.Stepper;
import arcomat.analysis.automaton.exploration.Visit;
import arcomat.analysis.reachability.Reachability;
import arcomat.analysis.reachability.Reachability.Reachable;
import arcomat.analysis.reachability.Reachability.Unreachable;
import arcomat.analysis.reachability.RunProperty;
import arcomat.analysis.reachability.Subject;
import arcomat.model.Automaton;
import arcomat.model.Component;
import arcomat.model.Port;
import arcomat.model.Type;
import arcomat.model.Value;
import arcomat.models.ReadModels;
import arcomat.semantics.automaton.StepRelation.Reaction;
import arcomat.semantics.automaton.StepRelation.Start;
import arcomat.source.SourceFile;

import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;

import java.util.List;
import java.util.Map;
import java.util.Random;
import java.util.TreeMap;

/**
 * What is said of automata that remember Doubles and multiply variables, against what random runs
 * show: nothing that can never be is seen, and nothing earlier than by a shortest run.
 */
class RandomRealRunsTest {
    private static final int MODELS = 3;
    private static final int RUNS = 200;
    private static final int LETTERS = 5;
    private static final List<String> NUMBERS =
            List.of("d", "v", "d + v", "v - d", "d * 0.5", "v * d", "(double) n", "-v", "d / v");
    private static final List<String> LIMITS =
            List.of("0.0", "-0.0", "1.0", "0.1", "1.0E308", "v", "d");
    private static final List<String> CONDITIONS =
            List.of("n * w == 12", "n * n % 4 == 3", "w * w < 0", "n > w", "w * n == 0", "true");
    private static final List<String> EFFECTS =
            List.of(
                    "v = d",
                    "v = v * 0.5",
                    "v = v + d",
                    "v = -v, x = v",
                    "w = w * n",
                    "w = n, x = d",
                    "w = w * w + 1, x = (double) w");
    private static final List<Double> DOUBLES =
            List.of(0.0, -0.0, 0.1, 0.5, 1.0, 2.0, -1.0, 1e308, Double.NaN, 1.0 / 0);
    private static final List<Integer> INTEGERS = List.of(0, 1, 2, 3, 4, 6, 12, -1, 1 << 16);

    @Tag("slow")
    @Test
    void runsShowNothingElse() {
        Map<String, Integer> decided = new TreeMap<>();
        for (int seed = 0; seed < MODELS; seed++) {
            String text = text(new Random(seed));
            Subject subject = subject(text);
            Map<RunProperty, Reachability> answers =
                    Models.answers(subject, new RunProperties(subject).all(), Models.SOLVERS);
            answers.values()
                    .forEach(
                            each ->
                                    decided.merge(
                                            each.getClass().getSimpleName(), 1, Integer::sum));
            for (int run = 0; run < RUNS; run++) {
                follow(subject, answers, new Random(run), text);
            }
        }
        int all = decided.values().stream().mapToInt(each -> each).sum();
        assertThat(decided.get("Reachable")).as("%s", decided).isGreaterThan(all / 5);
        assertThat(decided.get("Unreachable")).as("%s", decided).isGreaterThan(all / 8);
        assertThat(decided.getOrDefault("Unknown", 0)).as("%s", decided).isLessThan(all / 5);
    }

    private static String text(Random random) {
        StringBuilder lines = new StringBuilder();
        for (int i = 3 + random.nextInt(3); i > 0; i--) {
            lines.append(
                    "    s%d -> s%d [%s %s %s && %s] / {%s};%n"
                            .formatted(
                                    random.nextInt(2),
                                    random.nextInt(2),
                                    one(NUMBERS, random),
                                    one(List.of("<", "<=", "==", "!=", ">"), random),
                                    one(LIMITS, random),
                                    one(CONDITIONS, random),
                                    one(EFFECTS, random)));
        }
        return """
        component Random {
          port <<total>> in Double d, <<total>> in Integer n, out Double x;

          <<completion = "chaos">> automaton {
            state s0, s1;
            variable Double v = 1.0;
            variable Integer w = 1;
            initial s0;
        %s  }
        }
        """
                .formatted(lines);
    }

    private static <T> T one(List<T> all, Random random) {
        return all.get(random.nextInt(all.size()));
    }

    private static Subject subject(String text) {
        Component component =
                ReadModels.model(new SourceFile("Random.arc", text)).components().get(0);
        Automaton automaton = ((Component.Atomic) component.body()).automata().get(0);
        return Subject.of(component, automaton, List.of());
    }

    private static void follow(
            Subject subject, Map<RunProperty, Reachability> answers, Random random, String text) {
        Stepper stepper = Stepper.of(subject);
        Start start = subject.relation().starts().get(0);
        Visit visit = Visit.beginning(start.configuration(), start.output());
        for (int length = 0; length <= LETTERS; length++) {
            Value[] letter = letter(subject, random);
            Situation seen = stepper.situation(visit, letter, reaction -> -1);
            for (RunProperty shown : seen.shows()) {
                Reachability answer = answers.get(shown);
                assertThat(answer).as("%s of%n%s", shown, text).isNotInstanceOf(Unreachable.class);
                if (answer instanceof Reachable found) {
                    assertThat(found.run().letters().size())
                            .as("%s of%n%s", shown, text)
                            .isLessThanOrEqualTo(length);
                }
            }
            List<Reaction> reactions =
                    seen.alternatives().stream().flatMap(each -> each.reaction().stream()).toList();
            if (reactions.isEmpty()) {
                return;
            }
            visit = visit.then(one(reactions, random), stepper.latched(visit, letter), letter);
        }
    }

    private static Value[] letter(Subject subject, Random random) {
        return subject.component().inputs().stream()
                .map(port -> message(port, random))
                .toArray(Value[]::new);
    }

    private static Value message(Port port, Random random) {
        return port.type() instanceof Type.RealType
                ? new Value.RealValue(one(DOUBLES, random))
                : new Value.IntegerValue(one(INTEGERS, random));
    }
}
