package arcomat.pipeline.compile;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import arcomat.generate.Generation;
import arcomat.generate.Generator;
import arcomat.generate.Monitors;
import arcomat.generate.Request;
import arcomat.generate.Target;
import arcomat.generate.plan.Choosing;
import arcomat.lower.Lowering;
import arcomat.model.Component;
import arcomat.model.Model;
import arcomat.source.Diagnostic;
import arcomat.symbols.Scenario;

import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

import java.util.List;
import java.util.function.IntFunction;
import java.util.stream.Collectors;
import java.util.stream.IntStream;

/** What a Java virtual machine cannot hold is refused, and nothing else is. */
class OversizedCodeTest {
    private static final Target JVM = Target.shipped("jvm").orElseThrow();

    /**
     * @param ports of the component
     * @param body of its automaton, which has one state
     */
    private static Model model(String name, String ports, String body) {
        String text =
                """
                ==== Wide.arc
                component %s {
                  timing instant;
                  port %s;
                  <<completion = "ignore">> automaton {
                    state s;
                    initial s;
                    %s
                  }
                }
                """;
        return Lowering.lower(Scenario.of(text.formatted(name, ports, body)).workspace());
    }

    private static String list(int count, String each) {
        return IntStream.range(0, count)
                .mapToObj(i -> each.formatted(i))
                .collect(Collectors.joining(", "));
    }

    private static Model senders(int count) {
        String ports = "in Integer a, " + list(count, "out Integer b%d");
        return model("Wide", ports, "s {a == 1} / {" + list(count, "b%d = 1") + "};");
    }

    /**
     * @param timing of a cell and of the whole
     * @param ports of the whole
     * @param parts and connectors of the whole
     */
    private static Component whole(String timing, String ports, String parts) {
        String text =
                """
                ==== Cell.arc
                component Cell(Integer k) {
                  timing %s;
                  port in Integer a, out Integer b;
                  <<completion = "ignore">> automaton {
                    state s;
                    initial s;
                    s {a = ?} / {b = k};
                  }
                }
                ==== Whole.arc
                component Whole {
                  timing %s;
                  port %s;
                  %s
                }
                """;
        return Lowering.lower(Scenario.of(text.formatted(timing, timing, ports, parts)).workspace())
                .component("Whole")
                .orElseThrow();
    }

    private static String lines(int count, IntFunction<String> each) {
        return IntStream.range(0, count).mapToObj(each).collect(Collectors.joining("\n"));
    }

    /** Each port of the whole is that of the one part, so that copies are all that there is. */
    private static Component ports(String timing, int count) {
        return whole(
                timing,
                "in Integer a, " + list(count, "out Integer b%d"),
                "component Cell(1) c; connect a -> c.a;"
                        + lines(count, i -> "connect c.b -> b" + i + ";"));
    }

    private static Component chain(int parts) {
        return whole(
                "untimed",
                "in Integer a, out Integer b",
                lines(parts, i -> "component Cell(" + i + ") c" + i + ";")
                        + "connect a -> c0.a;"
                        + lines(parts - 1, i -> "connect c" + i + ".b -> c" + (i + 1) + ".a;")
                        + "connect c"
                        + (parts - 1)
                        + ".b -> b;");
    }

    private static Component star(int parts) {
        return whole(
                "untimed",
                "in Integer a, out Integer b",
                lines(parts, i -> "component Cell(1) c" + i + "; connect a -> c" + i + ".a;"));
    }

    /** What is many is spread over methods and classes. */
    @Tag("slow")
    @ParameterizedTest
    @ValueSource(strings = {"delayed", "instant"})
    void compositesWithThousandsOfPorts(String timing) {
        assertThat(findings(ports(timing, 3_500))).isEmpty();
    }

    @Tag("slow")
    @Test
    void compositesOfThousandsOfEventDrivenParts() {
        assertThat(findings(chain(5_500))).isEmpty();
        assertThat(findings(star(5_500))).isEmpty();
    }

    @Test
    void aFewHundredEventDrivenPartsLiveInSections() {
        assertThat(files(chain(100))).containsExactlyInAnyOrder("Cell", "Whole");
        assertThat(files(chain(101)))
                .containsExactlyInAnyOrder("Cell", "Whole", "WholeSection0", "WholeSection1");
        assertThat(findings(chain(250))).isEmpty();
        assertThat(findings(star(700))).isEmpty();
    }

    private static List<String> files(Component whole) {
        return Generator.generate(Request.library(whole, Choosing.FIRST), JVM).files().stream()
                .map(file -> file.path().replaceAll(".*/|\\.java", ""))
                .toList();
    }

    private static List<String> findings(Model model) {
        return findings(model.components().get(0));
    }

    private static List<String> findings(Component component) {
        Generation generation = Generator.generate(Request.library(component, Choosing.FIRST), JVM);
        assertThat(generation.findings()).isEmpty();
        return OversizedCode.in(generation).stream().map(OversizedCodeTest::shown).toList();
    }

    private static String shown(Diagnostic finding) {
        return finding.code() + ": " + finding.message();
    }

    private static String said(String what) {
        return "ARC0810: the code of 'Wide' is too large for Java: it would have "
                + what
                + "; make several of it";
    }

    @ParameterizedTest
    @CsvSource({"254, true", "255, false"})
    void parameters(int count, boolean fits) {
        String name = "Wide(" + list(count, "Boolean p%d") + ")";
        Model model = model(name, "in Boolean a, out Boolean b", "s {a == true} / {b = p0};");

        assertThat(findings(model))
                .isEqualTo(fits ? List.of() : List.of(said(JavaLimit.PARAMETERS.words())));
    }

    @Tag("slow")
    @Test
    void aTransitionThatSendsOnThousandsOfPorts() {
        assertThat(findings(senders(3_000))).isEmpty();
        assertThat(findings(senders(8_000))).containsExactly(said(JavaLimit.METHOD.words()));
        Component component = senders(8_000).components().get(0);
        assertThatThrownBy(() -> CompiledModel.of(component, Choosing.FIRST))
                .isInstanceOf(CompiledModel.TooLargeToCompile.class)
                .hasMessageContaining(JavaLimit.METHOD.words());
    }

    @Test
    void aTextAsLongAsAMethod() {
        String ports = "in Boolean a, out String b";
        String sent = "s {a == true} / {b = \"%s\"};";

        assertThat(findings(model("Wide", ports, sent.formatted("x".repeat(65_535))))).isEmpty();
        assertThat(findings(model("Wide", ports, sent.formatted("x".repeat(65_536)))))
                .containsExactly(said(JavaLimit.TEXT.words()));
        assertThat(findings(model("Wide", ports, sent.formatted("\u20ac".repeat(21_846)))))
                .containsExactly(said(JavaLimit.TEXT.words()));
    }

    @Tag("slow")
    @Test
    void aMonitor() {
        Component watched = senders(8_000).components().get(0);
        Generation generation = Monitors.generate(watched, watched.automata(), JVM);

        assertThat(generation.findings()).isEmpty();
        assertThat(OversizedCode.in(generation))
                .extracting(Diagnostic::message)
                .containsExactly(
                        "the code of 'WideMonitor' is too large for Java: it would have "
                                + JavaLimit.METHOD.words()
                                + "; make several of it");
    }

    @Test
    void literals() {
        assertThat(StringConstants.longest("x = 'a' + '\"' + \"ab\\\"c\" + y + \"\\u20ac\\000\";"))
                .isEqualTo(5);
        assertThat(StringConstants.longest("\"ab\" + \"cde\" + x + \"f\"")).isEqualTo(5);
        assertThat(StringConstants.longest("\"\"")).isZero();
        assertThat(StringConstants.longest("int a; // don't \"s\n/* \"some */ x = \"a\""))
                .isEqualTo(1);
    }
}
