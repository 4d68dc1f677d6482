package statemachine;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Random;
import java.util.TreeMap;
import java.util.stream.Collectors;
import java.util.stream.IntStream;

/** Interpreter and compiled code do what the reference may do, and both the same. */
class EnginesTest {
    private static final int MACHINES = Integer.getInteger("machines", 10);

    /** As many run side by side, as parts of one component. */
    private static final int GROUP = 10;

    private static final int SLICES = 30;

    @TempDir private Path folder;

    @Test
    void doWhatTheReferenceDoes() throws Exception {
        long seed = Long.getLong("seed", 93);
        Random random = new Random(seed);
        for (int i = 0; i < MACHINES; i += GROUP) {
            Path group = Files.createDirectory(folder.resolve("group" + i));
            List<DrawnMachine> machines = new ArrayList<>();
            for (int k = 0; k < GROUP; k++) {
                machines.add(DrawnMachine.draw(random));
                String name = "Machine" + k;
                Files.writeString(group.resolve(name + ".arc"), machines.get(k).text(name));
            }
            List<Optional<Boolean>> inputs = new ArrayList<>();
            for (int slice = 0; slice < SLICES; slice++) {
                boolean silent = random.nextInt(4) == 0;
                inputs.add(silent ? Optional.empty() : Optional.of(random.nextBoolean()));
            }
            compare(group, machines, inputs, "seed %d, group %d".formatted(seed, i));
        }
    }

    private static void compare(
            Path group, List<DrawnMachine> machines, List<Optional<Boolean>> inputs, String name)
            throws Exception {
        Files.writeString(group.resolve("All.arc"), all(machines.size()));
        String stream =
                inputs.stream()
                        .map(each -> each.map(a -> a + ", Tk").orElse("Tk"))
                        .collect(Collectors.joining(", "));
        Files.writeString(
                group.resolve("AllTest.mt"),
                "testsuite AllTest for All { test run { input { a: <%s>; } expect {} } }"
                        .formatted(stream));
        String interpreted = run(group, "interpreter");
        assertThat(run(group, "compiled")).as(name).isEqualTo(interpreted);
        List<Map<String, String>> rows = rows(interpreted);
        for (int i = 0; i < machines.size(); i++) {
            List<Map<String, Integer>> outputs = new ArrayList<>();
            for (Map<String, String> row : rows) {
                outputs.add(sent(row, i));
            }
            Course course = new Course(inputs.subList(0, SLICES - 1), outputs);
            assertThat(course.isPossible(new ReferenceMachine(machines.get(i))))
                    .as("%s: machine %d\n%s", name, i, machines.get(i).text("Machine"))
                    .isTrue();
        }
    }

    private static String run(Path group, String engine) throws Exception {
        return Tool.run(
                group,
                "simulate",
                "--trace",
                "csv",
                "--engine",
                engine,
                "--input",
                "AllTest.mt#run",
                ".");
    }

    /** All machines side by side; each hears the same. */
    private static String all(int machines) {
        StringBuilder text = new StringBuilder("component All {\nport in Boolean a");
        StringBuilder parts = new StringBuilder();
        for (int i = 0; i < machines; i++) {
            parts.append("component Machine%1$d m%1$d;\nconnect a -> m%1$d.a;\n".formatted(i));
            for (String port : DrawnMachine.PORTS) {
                text.append(", out Integer %s_%d".formatted(port, i));
                parts.append("connect m%2$d.%1$s -> %1$s_%2$d;\n".formatted(port, i));
            }
        }
        return text.append(";\n").append(parts).append("}\n").toString();
    }

    /** By the names of the columns; no cell of them has a comma in it. */
    private static List<Map<String, String>> rows(String csv) {
        List<String[]> lines = csv.lines().map(line -> line.split(",", -1)).toList();
        String[] names = lines.get(0);
        return lines.stream()
                .skip(1)
                .map(
                        cells ->
                                IntStream.range(0, names.length)
                                        .boxed()
                                        .collect(Collectors.toMap(i -> names[i], i -> cells[i])))
                .toList();
    }

    private static Map<String, Integer> sent(Map<String, String> row, int machine) {
        Map<String, Integer> sent = new TreeMap<>();
        for (String port : DrawnMachine.PORTS) {
            String cell = row.get("out %s_%d".formatted(port, machine));
            if (!cell.isEmpty()) {
                sent.put(port, Integer.valueOf(cell));
            }
        }
        return sent;
    }
}
