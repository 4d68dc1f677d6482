package arcomat.generate;

import static org.assertj.core.api.Assertions.assertThat;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import arcomat.generate.plan.Choosing;
import arcomat.lower.Lowering;
import arcomat.model.Component;
import arcomat.model.Letter;
import arcomat.model.Port;
import arcomat.model.Trace;
import arcomat.model.Type;
import arcomat.model.Value;
import arcomat.simulate.run.Choice;
import arcomat.simulate.run.Interpreter;
import arcomat.symbols.Scenario;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Random;
import java.util.TreeMap;
import java.util.concurrent.TimeUnit;
import java.util.stream.Stream;

/** A target for another language is a folder of templates: plain C, compiled where there is cc. */
class PlainCTest {
    private static final Path FOLDER = Path.of("src/test/resources/targets/c");

    @TempDir Path output;

    private static Component counter() {
        Path file = Path.of("src/test/resources/targets/Counter.txt");
        return Lowering.lower(Scenario.read(file).workspace()).component("p.Counter").orElseThrow();
    }

    private List<GeneratedFile> generate() throws IOException {
        Map<String, String> texts = new TreeMap<>();
        try (Stream<Path> files = Files.list(FOLDER)) {
            for (Path file : files.toList()) {
                texts.put(file.getFileName().toString(), Files.readString(file));
            }
        }
        Generation generation =
                Generator.generate(
                        Request.program(counter(), Choosing.FIRST), new Target("c", texts));
        assertThat(generation.findings()).isEmpty();
        return generation.files();
    }

    @Test
    void conditionsAndValuesAreC() throws IOException {
        String text =
                generate().stream()
                        .filter(f -> f.path().equals("p_logic_Counter.c"))
                        .findFirst()
                        .orElseThrow()
                        .text();
        assertThat(text)
                .contains(
                        "if (self->key == p_t_Key_UP && self->has_by"
                                + " && self->value + self->by > 12 && !self->loud) {")
                .contains("self->count = self->value - -self->by;")
                .contains("self->count = self->before * (self->value - 2);");
    }

    @Test
    void itRunsLikeTheModel() throws Exception {
        assumeTrue(run(List.of("cc", "--version"), "") != null, "no C compiler");
        List<String> command = new ArrayList<>(List.of("cc", "-Wall", "-Werror", "-o", "run"));
        for (GeneratedFile file : generate()) {
            Files.writeString(output.resolve(file.path()), file.text());
            if (file.path().endsWith(".c")) {
                command.add(file.path());
            }
        }
        assertThat(run(command, "")).isEmpty();
        StringBuilder input = new StringBuilder();
        String expected = interpret(input);
        assertThat(run(List.of(output.resolve("run").toString()), input.toString()))
                .isEqualTo(expected);
    }

    /** The words that the program reads, and what the interpreter says to them. */
    private static String interpret(StringBuilder input) {
        Component counter = counter();
        Interpreter interpreter = new Interpreter(counter, List.of(), Choice.first());
        Random random = new Random(1);
        StringBuilder shown = new StringBuilder();
        for (int slice = 0; slice < 300; slice++) {
            Map<String, Value> letter = new LinkedHashMap<>();
            for (Port port : counter.inputs()) {
                boolean present = port.total() || random.nextBoolean();
                int message = random.nextInt(3);
                if (port.type() instanceof Type.EnumType type) {
                    input.append("1 ").append(present ? message + 1 : 0).append(' ');
                    put(present, letter, port, new Value.EnumValue(type, message));
                } else if (port.type() instanceof Type.BooleanType) {
                    input.append("1 ").append(message == 0 ? 1 : 0).append(' ');
                    put(present, letter, port, new Value.BooleanValue(message == 0));
                } else {
                    input.append(present ? "1 " : "0 ").append(message).append(' ');
                    put(present, letter, port, new Value.IntegerValue(message));
                }
            }
            input.append('\n');
            Trace.Step step = interpreter.step(Letter.of(letter));
            for (String port : List.of("count", "last", "echo")) {
                shown.append(text(step.outputs(), port)).append(' ');
            }
            String state = step.activities().get(0).after();
            shown.append(state.equals("low") ? 0 : 1).append('\n');
        }
        return shown.toString();
    }

    private static void put(boolean present, Map<String, Value> letter, Port port, Value value) {
        if (present) {
            letter.put(port.name(), value);
        }
    }

    private static String text(Letter outputs, String port) {
        Value value = outputs.message(port).orElse(null);
        if (value instanceof Value.EnumValue constant) {
            return String.valueOf(constant.ordinal() + 1);
        }
        return value == null ? port.equals("count") ? "-" : "0" : value.toString();
    }

    /** What a program prints, or null where there is no such program. */
    private String run(List<String> command, String input) throws Exception {
        Path fed = Files.writeString(output.resolve("input"), input);
        Path printed = output.resolve("printed");
        try {
            Process process =
                    new ProcessBuilder(command)
                            .directory(output.toFile())
                            .redirectInput(fed.toFile())
                            .redirectErrorStream(true)
                            .redirectOutput(printed.toFile())
                            .start();
            assertThat(process.waitFor(60, TimeUnit.SECONDS)).isTrue();
            return Files.readString(printed);
        } catch (IOException e) {
            return null;
        }
    }
}
