package arcomat.generate;

import static org.assertj.core.api.Assertions.assertThat;

import arcomat.generate.plan.Choosing;
import arcomat.lower.Lowering;
import arcomat.model.Automaton.Completion;
import arcomat.model.Component;
import arcomat.model.Model;
import arcomat.semantics.ComponentBuilder;
import arcomat.source.Diagnostic;
import arcomat.symbols.Scenario;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

import java.util.HashMap;
import java.util.List;
import java.util.Map;

/** Targets that a user brings along: what they can do, and what they cannot. */
class OwnTargetTest {
    private static final Request REQUEST =
            Request.library(SampleComponents.undecided(), Choosing.FIRST);

    private static Generation generate(String template, String path) {
        Map<String, String> files =
                Map.of("target.properties", description(path), "t.ftl", template);
        return Generator.generate(REQUEST, new Target("own", files));
    }

    private static String description(String path) {
        return "template.t.ftl = atomic | "
                + path
                + "\nflag = has{Port}\n"
                + "reference.brief = {name}\nexpression.type = {type}\n"
                + "expression.literal = {code}\nexpression.port = {name}\n"
                + "expression.equal = {0} = {1}\nexpression.not_equal = {0} /= {1}\n"
                + "expression.present = there is {name}\nexpression.silence = nothing\n"
                + "expression.literal.string = <{value}>\n";
    }

    @Test
    void templatesSeeReadyMadeText() {
        String template =
                "<#list sections as section><#list section.states as some>"
                        + "<#list some.transitions as t>${some.name}: ${t.condition}\n"
                        + "</#list></#list></#list>";
        assertThat(generate(template, "{folder}{name}.txt").files())
                .containsExactly(
                        new GeneratedFile(
                                "coffee/logic/Undecided.txt",
                                "driving: frontUS = TOO_CLOSE\n"
                                        + "driving: frontUS = TOO_CLOSE\n"
                                        + "waiting: frontUS = CLEAR\n"));
    }

    /** In whatever country the machine stands. */
    @Test
    void numbersHaveNoSeparators() {
        assertThat(generate("${1234567} ${0.5}", "{name}.txt").files())
                .extracting(GeneratedFile::text)
                .containsExactly("1234567 0.5");
    }

    /** Damaged descriptions: what is no place, or no level, is text. */
    @ParameterizedTest
    @ValueSource(
            strings = {
                "reserved = int char int",
                "expression.equal = 99999999999 | {0} = {1}",
                "expression.equal = {0x} = {1}",
                "expression.equal = {99999999999} = {0:99999999999}"
            })
    void oddEntriesAreTakenAsText(String entry) {
        Map<String, String> files =
                Map.of(
                        "target.properties",
                        description("{name}.txt") + entry + "\n",
                        "t.ftl",
                        "${head.name}");
        assertThat(Generator.generate(REQUEST, new Target("own", files)).findings()).isEmpty();
    }

    @Test
    void aMistakeInATemplateIsShownWhereItIs() {
        Diagnostic finding = generate("one\n  ${missing}", "{name}.txt").findings().get(0);
        assertThat(finding.span().startPosition().column()).isEqualTo(5);
        assertThat(finding.message())
                .startsWith("template t.ftl cannot be filled in: The following has evaluated to")
                .doesNotContain("Tip", "\n");
    }

    @ParameterizedTest
    @ValueSource(
            strings = {
                "${\"freemarker.template.utility.Execute\"?new()(\"id\")}",
                "${\"freemarker.template.utility.ObjectConstructor\"?new()(\"java.lang.Object\")}",
                "${head?api.getClass()}",
                "${head.class}",
                "${head.getClass()}",
                "${.data_model.class}",
                "${head.name.class.protectionDomain}",
                "<#include \"/etc/passwd\">",
                "<#include \"../../secret.txt\">",
                "${missing}",
                "<#if>",
                "<#list sections as s>${s.x.y}</#list>",
                "${sections[1]}",
                "${sections[-1]}"
            })
    void templatesReachNothingElse(String template) {
        Generation generation = generate("\n" + template, "{name}.txt");
        assertThat(generation.files()).isEmpty();
        assertThat(generation.findings()).hasSize(1);
        Diagnostic finding = generation.findings().get(0);
        assertThat(finding.code()).isEqualTo("ARC0802");
        assertThat(finding.span().file().path()).isEqualTo("own/t.ftl");
        assertThat(finding.span().startPosition().line()).isEqualTo(2);
    }

    @Test
    void aTemplateThatCallsItselfEnds() {
        Generation generation = generate("<#macro again><@again/></#macro><@again/>", "{name}.txt");
        assertThat(generation.files()).isEmpty();
        assertThat(generation.findings())
                .extracting(Diagnostic::message)
                .singleElement()
                .asString()
                .contains("calls itself without end");
    }

    @ParameterizedTest
    @ValueSource(
            strings = {
                "../{name}.txt",
                ".arcomat-generated",
                "/tmp/{name}.txt",
                "a/../../{name}",
                "a//{name}",
                "C:{name}",
                "..\\\\{name}",
                "a/./{name}",
                "{folder}"
            })
    void noPathLeavesTheOutputFolder(String path) {
        Generation generation = generate("x", path);
        assertThat(generation.files()).isEmpty();
        assertThat(generation.findings()).extracting(Diagnostic::code).containsExactly("ARC0804");
    }

    @ParameterizedTest
    @CsvSource({
        "expression.port, the model needs an entry that is not there, ARC0803",
        "template.t.ftl = nothing | x, a subject that does not exist, ARC0803"
    })
    void whatADescriptionLacksIsSaid(String entry, String why, String code) {
        String description = entry.contains("=") ? entry : "template.t.ftl = atomic | {name}";
        Target target = new Target("own", Map.of("target.properties", description, "t.ftl", "x"));
        List<Diagnostic> findings = Generator.generate(REQUEST, target).findings();
        assertThat(findings).as(why).extracting(Diagnostic::code).containsExactly(code);
    }

    /** Two components whose files get one path overwrite nothing silently. */
    @Test
    void noFileIsWrittenTwice() {
        Component whole = SampleComponents.whole();
        String description = "template.t.ftl = enum | types.txt\nflag = has{Port}\n";
        Target base = Target.shipped("jvm").orElseThrow();
        Target target =
                new Target(
                        "own",
                        Map.of(
                                "target.properties",
                                base.files()
                                                .get("target.properties")
                                                .replaceAll("(?m)^template.*", "")
                                        + description,
                                "t.ftl",
                                "x"));
        assertThat(Generator.generate(Request.library(whole, Choosing.FIRST), target).findings())
                .extracting(Diagnostic::code)
                .contains("ARC0804");
        OutputFiles output = new OutputFiles(target, new TargetFindings(target));
        output.copy("a", "first");
        output.copy("A", "second");
        assertThat(output.all()).containsExactly(new GeneratedFile("a", "first"));
    }

    private static final String DEVICES =
            """
            ==== p/Words.cd
            package p;
            classdiagram Words { enum Socket { A, B, C } }
            ==== p/Lamp.arc
            package p;
            import p.Words.*;
            <<platform, layer = "actuators">> component Lamp(Socket socket) { port in Boolean on; }
            ==== p/Box.arc
            package p;
            <<platform, layer = "actuators">> component Box<T> { port in T filled; }
            ==== p/Robot.arc
            package p;
            import p.Words.*;
            <<deploy>> component Robot {
              port in Boolean on, in Integer number, in Socket word;
              component Lamp(Socket.A) left;
              component Lamp(Socket.A) right;
              component Box<Integer> numbers;
              component Box<Socket> words;
              connect on -> left.on, right.on;
              connect number -> numbers.filled;
              connect word -> words.filled;
            }
            """;

    private static Generation robot(Map<String, String> handwritten, String... entries) {
        Target jvm = Target.shipped("jvm").orElseThrow();
        Map<String, String> files = new HashMap<>(jvm.files());
        files.merge("target.properties", "\n" + String.join("\n", entries), String::concat);
        Model model = Lowering.lower(Scenario.of(DEVICES).workspace());
        Component robot = model.component("p.Robot").orElseThrow();
        return Generator.generate(
                Request.program(robot, Choosing.FIRST).with(handwritten), new Target("own", files));
    }

    @Test
    void twoDevicesDoNotFitIntoOneSocket() {
        assertThat(robot(Map.of()).findings()).isEmpty();
        assertThat(robot(Map.of(), "sockets = p.Words.Socket").findings())
                .extracting(Diagnostic::message)
                .containsExactly("'right' is plugged into socket A like 'left'; free are B, C");
    }

    /** Messages that are enums are numbers, whatever the enum; others are not alike. */
    @Test
    void aClassForAllInstantiationsServesThoseWithEnums() {
        Generation generation =
                robot(
                        Map.of(
                                "p/actuators/Box.java",
                                "by hand",
                                "p/actuators/Lamp.java",
                                "by hand"),
                        "platform = class");
        assertThat(generation.findings())
                .extracting(Diagnostic::message)
                .singleElement()
                .asString()
                .contains("platform component p.Box<Integer> needs an implementation");
    }

    /** Code for a random choice has a case for each set of enabled transitions. */
    @Test
    void tooManyAlternativesForARandomChoiceAreNamed() {
        ComponentBuilder.AutomatonBuilder undecided =
                ComponentBuilder.component("Undecided")
                        .in(ComponentBuilder.MOTOR, "x")
                        .automaton(Completion.CHAOS, "only")
                        .initial("only", "");
        for (int i = 0; i < 70; i++) {
            undecided.on("only", "x = ?", "");
        }
        Request request = Request.library(undecided.build(), Choosing.RANDOM);
        Generation generation = Generator.generate(request, Target.shipped("jvm").orElseThrow());
        assertThat(generation.files()).isEmpty();
        assertThat(generation.findings()).extracting(Diagnostic::code).containsExactly("ARC0805");
    }

    /** A target may leave platform components to classes that somebody writes. */
    @Test
    void aMissingImplementationIsNamedWithItsPlaceAndASkeleton() {
        Target jvm = Target.shipped("jvm").orElseThrow();
        Map<String, String> files = new HashMap<>(jvm.files());
        files.merge("target.properties", "\nplatform = class\n", String::concat);
        Target brick = new Target("my/brick", files);
        Request request = Request.library(SampleComponents.whole(), Choosing.FIRST);

        Generation missing = Generator.generate(request, brick);
        assertThat(missing.files()).isEmpty();
        assertThat(missing.findings()).hasSize(1);
        assertThat(missing.findings().get(0).code()).isEqualTo("ARC0801");
        assertThat(missing.findings().get(0).message())
                .contains("write platform/brick/coffee/logic/Light.java under the model root")
                .contains("public final class Light {");

        String own = "package coffee.logic; public class Light {}";
        Generation found =
                Generator.generate(request.with(Map.of("coffee/logic/Light.java", own)), brick);
        assertThat(found.findings()).isEmpty();
        assertThat(found.files()).contains(new GeneratedFile("coffee/logic/Light.java", own));
    }
}
