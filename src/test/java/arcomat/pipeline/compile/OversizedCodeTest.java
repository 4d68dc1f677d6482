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

import java.util.List;
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

    private static List<String> findings(Model model) {
        Component component = model.components().get(0);
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
