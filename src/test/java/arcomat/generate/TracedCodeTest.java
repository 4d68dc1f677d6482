package arcomat.generate;

import static org.assertj.core.api.Assertions.assertThat;

import arcomat.generate.plan.Choosing;
import arcomat.lower.Lowering;
import arcomat.model.Model;
import arcomat.symbols.Scenario;

import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Iterator;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import java.util.function.IntFunction;
import java.util.stream.Collectors;
import java.util.stream.IntStream;

/**
 * The code that an engine runs and looks at is the code that users get, with notes: what holds for
 * the one in a run holds for the other.
 */
class TracedCodeTest {
    private static final String NOTE =
            "\\s*|\\s*(private int )?(state|taken)_* = .*;|\\s*private int"
                    + " (state|taken)_*;|\\s*public static final int \\w+ = \\d+;|\\s*/\\*\\* The"
                    + " transition taken last.*";

    private static final String DONE = "\\s*return( true)?;";

    @ParameterizedTest
    @ValueSource(
            strings = {"composition", "events", "expressions", "guards", "latched", "mentions"})
    void hasNotesAndNothingElse(String file) {
        Path path = Path.of("src/test/resources/agreement", file + ".txt");
        Model model = Lowering.lower(Scenario.read(path).workspace());
        for (Choosing choosing : Choosing.values()) {
            Request request = Request.all(model, choosing);
            Map<String, String> plain = files(request);
            Map<String, String> traced = files(request.withTrace());
            assertThat(traced.keySet()).isEqualTo(plain.keySet());
            assertThat(traced).isNotEqualTo(plain);
            traced.forEach((name, text) -> hasNotes(name, text, plain.get(name)));
        }
    }

    private static Map<String, String> files(Request request) {
        Map<String, String> files = new TreeMap<>();
        Generation generation = Generator.generate(request, Target.shipped("jvm").orElseThrow());
        assertThat(generation.findings()).isEmpty();
        generation.files().forEach(each -> files.put(each.path(), each.text()));
        return files;
    }

    /**
     * What marks say is what notes say, which are code: each is right before the line it is about.
     */
    @ParameterizedTest
    @ValueSource(
            strings = {"composition", "events", "expressions", "guards", "latched", "mentions"})
    void theLineBehindANoteIsThatOfTheMark(String file) {
        Path path = Path.of("src/test/resources/agreement", file + ".txt");
        check(Lowering.lower(Scenario.read(path).workspace()));
    }

    /**
     * So many transitions that a state has several methods, and so many states that these share.
     */
    @Tag("slow")
    @Test
    void inMethodsOfTheirOwnToo() {
        assertThat(check(large("a, b", 900, i -> "a -> b"))).isEqualTo(1800);
        String states = names(IntStream.range(0, 300));
        assertThat(check(large(states, 300, i -> "s" + i + " -> s" + (i + 1) % 300)))
                .isEqualTo(600);
    }

    private static String names(IntStream numbers) {
        return numbers.mapToObj(i -> "s" + i).collect(Collectors.joining(", "));
    }

    private static Model large(String states, int transitions, IntFunction<String> arrow) {
        StringBuilder text =
                new StringBuilder("==== p/A.arc\npackage p;\ncomponent A {\n    timing instant;\n");
        text.append("    port <<total>> in Integer i, out Integer o;\n");
        text.append("    <<completion = \"ignore\">> automaton {\n        state ").append(states);
        text.append(";\n        initial ").append(states.replaceFirst(",.*", "")).append(";\n");
        for (int i = 0; i < transitions; i++) {
            text.append("        %s [i == %d] / {o = %d};\n".formatted(arrow.apply(i), i, i));
        }
        return Lowering.lower(Scenario.of(text + "    }\n}\n").workspace());
    }

    private static int check(Model model) {
        int marks = 0;
        for (Choosing choosing : Choosing.values()) {
            Request request = Request.all(model, choosing);
            Generation plain = Generator.generate(request, Target.shipped("jvm").orElseThrow());
            Generation traced =
                    Generator.generate(request.withTrace(), Target.shipped("jvm").orElseThrow());
            Map<String, String> texts = files(request.withTrace());
            assertThat(plain.layout().automata()).isNotEmpty();
            for (AutomatonLines each : traced.layout().automata()) {
                String file = texts.get(each.className().replace('.', '/') + ".java");
                marks += follow(file.lines().toList(), each);
            }
            for (AutomatonLines each : plain.layout().automata()) {
                String file = files(request).get(each.className().replace('.', '/') + ".java");
                each.lines()
                        .transitions()
                        .values()
                        .forEach(
                                line ->
                                        assertThat(line(file.lines().toList(), line))
                                                .matches(DONE));
            }
        }
        return marks;
    }

    private static int follow(List<String> lines, AutomatonLines automaton) {
        long notes = lines.stream().filter(each -> each.matches("\\s*taken_* = \\d+;")).count();
        Map<Integer, Integer> marks = automaton.lines().transitions();
        assertThat((long) marks.size()).isEqualTo(notes);
        marks.forEach(
                (index, line) -> {
                    assertThat(line(lines, line)).matches(DONE);
                    assertThat(line(lines, line - 1)).matches("\\s*taken_* = " + index + ";");
                });
        automaton
                .lines()
                .initials()
                .values()
                .forEach(line -> assertThat(line(lines, line)).matches("    }|\\s*break;"));
        assertThat(automaton.lines().initials()).containsKey(0);
        return marks.size();
    }

    private static String line(List<String> lines, int number) {
        return lines.get(number - 1);
    }

    private static void hasNotes(String name, String traced, String plain) {
        List<String> added = new ArrayList<>();
        Iterator<String> expected = plain.lines().iterator();
        String next = expected.hasNext() ? expected.next() : "";
        for (String line : traced.lines().toList()) {
            if (line.equals(next)) {
                next = expected.hasNext() ? expected.next() : "";
            } else {
                added.add(line);
            }
        }
        assertThat(expected.hasNext()).as(name).isFalse();
        assertThat(added).as(name).allMatch(line -> line.matches(NOTE));
    }
}
