package statemachine;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

import statemachine.ReferenceMachine.Reaction;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Random;
import java.util.stream.Collectors;

/**
 * Machines that are drawn by lot do as automata what the reference says: what it can show passes as
 * a stream test, and what it cannot show fails.
 */
class FlatteningTest {
    private static final int MACHINES = Integer.getInteger("machines", 100);
    private static final int RUNS = 8;
    private static final int SLICES = 12;

    /** How many machines are tried that differ, until one shows what cannot be. */
    private static final int TRIES = 6;

    @TempDir private Path folder;

    @Test
    void doesWhatTheReferenceDoes() throws Exception {
        long seed = Long.getLong("seed", 16);
        Random random = new Random(seed);
        int wrong = 0;
        for (int i = 0; i < MACHINES; i++) {
            DrawnMachine machine = DrawnMachine.draw(random);
            String name = "Machine" + i;
            Files.writeString(folder.resolve(name + ".arc"), machine.text(name));
            StringBuilder suite =
                    new StringBuilder("testsuite " + name + "Test for " + name + " {\n");
            for (int run = 0; run < RUNS; run++) {
                wrong += run(machine, random, i + "of" + run, suite) ? 1 : 0;
            }
            Files.writeString(folder.resolve(name + "Test.mt"), suite + "}\n");
        }
        String printed = Tool.run(folder, "test", ".");
        assertThat(printed.lines().filter(line -> line.matches("  (FAILED right|passed wrong).*")))
                .as("seed %d", seed)
                .isEmpty();
        int right = MACHINES * RUNS - wrong;
        assertThat(printed).endsWith("%d passed, %d failed\n".formatted(right, wrong));
        assertThat(wrong).isGreaterThan(MACHINES);
    }

    private static Course course(DrawnMachine machine, Random random) {
        ReferenceMachine reference = new ReferenceMachine(machine);
        List<Optional<Boolean>> inputs = new ArrayList<>();
        List<Map<String, Integer>> outputs = new ArrayList<>();
        Reaction reaction = reference.start();
        outputs.add(reaction.sent());
        for (int i = 0; i < SLICES; i++) {
            inputs.add(
                    random.nextInt(4) == 0 ? Optional.empty() : Optional.of(random.nextBoolean()));
            List<Reaction> all = reference.reactions(reaction.next(), inputs.get(i));
            reaction = all.get(random.nextInt(all.size()));
            outputs.add(reaction.sent());
        }
        return new Course(inputs, outputs);
    }

    /** Writes a test: what the machine shows, or what one shows that differs in one place. */
    private static boolean run(
            DrawnMachine machine, Random random, String name, StringBuilder suite) {
        Course course = course(machine, random);
        boolean wrong = false;
        boolean other = random.nextBoolean();
        for (int i = 0; i < TRIES && other && !wrong; i++) {
            course = course(machine.variant(random), random);
            wrong = !course.isPossible(new ReferenceMachine(machine));
        }
        suite.append("test ")
                .append(wrong ? "wrong" : "right")
                .append(name)
                .append(" {\ninput {\na: <");
        suite.append(stream(course.inputs())).append(">;\n}\nexpect {\n");
        for (String port : DrawnMachine.PORTS) {
            List<Optional<Integer>> sent =
                    course.outputs().stream()
                            .map(each -> Optional.ofNullable(each.get(port)))
                            .toList();
            suite.append(port).append(": <").append(stream(sent)).append(">;\n");
        }
        suite.append("}\n}\n");
        return wrong;
    }

    private static String stream(List<? extends Optional<?>> messages) {
        return messages.stream()
                .map(each -> each.map(message -> message + ", ").orElse("") + "Tk")
                .collect(Collectors.joining(", "));
    }
}
