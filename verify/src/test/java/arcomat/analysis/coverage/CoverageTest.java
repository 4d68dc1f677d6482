package arcomat.analysis.coverage;

import static org.assertj.core.api.Assertions.assertThat;
import static org.junit.jupiter.api.DynamicTest.dynamicTest;

import arcomat.analysis.coverage.TransitionTests.Mistake;
import arcomat.analysis.refinement.Verdict;
import arcomat.analysis.search.Budget;
import arcomat.lower.Lowering;
import arcomat.model.Component;
import arcomat.model.StreamTest;
import arcomat.model.Value;
import arcomat.semantics.Promise;
import arcomat.symbols.Scenario;

import org.junit.jupiter.api.DynamicTest;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.TestFactory;

import java.nio.file.Path;
import java.util.Collections;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.TreeMap;
import java.util.regex.MatchResult;
import java.util.regex.Pattern;
import java.util.stream.Collectors;
import java.util.stream.Stream;

/** The tests of some components, line by line, and what they leave open. */
class CoverageTest {
    private static final Path DATA =
            Path.of("verify/src/test/resources/analysis/tests/coverage.txt");

    /** Expected of a component are its line and all lines up to that of the next one. */
    private static final Pattern EXPECTED =
            Pattern.compile(
                    "(?m)^(\\w+) (?:holds|fails|unknown): .*\n"
                            + "(?:(?!\\w+ (?:holds|fails|unknown): ).*\n"
                            + ")*");

    @Tag("some-slow")
    @TestFactory
    Stream<DynamicTest> whatIsTestedAndWhatIsNot() {
        Scenario scenario = Scenario.read(DATA);
        Map<String, String> expected =
                EXPECTED.matcher(scenario.expected())
                        .results()
                        .collect(Collectors.toMap(each -> each.group(1), MatchResult::group));
        List<Component> components = Lowering.lower(scenario.workspace()).components();
        assertThat(components).extracting(Component::name).containsAll(expected.keySet());
        return components.stream()
                .map(each -> dynamicTest(each.name(), () -> check(each, expected)));
    }

    private static void check(Component component, Map<String, String> expected) {
        String found = text(component).collect(Collectors.joining("\n", "", "\n"));
        assertThat(found).isEqualTo(expected.get(component.name()));
    }

    private static Promise promise(String text) {
        Scenario scenario = Scenario.of("==== p/C.arc\npackage p;\n" + text);
        return Promise.of(
                Lowering.lower(scenario.workspace()).component("p.C").orElseThrow(), List.of());
    }

    /** What stays open is not certain then, and says why; the tests that there are, stay. */
    @Test
    void timeEndsInTheMiddle() {
        Promise promise =
                promise(
                        """
                        component C {
                          port in Boolean x, out Boolean y;
                          <<completion = "ignore">> automaton {
                            state a, b, c;
                            initial a;
                            a -> b {x == true} / {y = true};
                            a -> c {x == false} / {y = false};
                          }
                        }
                        """);
        Set<String> reasons = new LinkedHashSet<>();
        TransitionTests.Result result;
        long times = 0;
        do {
            result = TransitionTests.of(promise, "Tests", Budget.ofMemory().patient(times++));
            int tests = result.tests().size();
            result.uncovered().forEach(each -> reasons.add(tests + " tests, " + each.reason()));
            assertThat(result.uncovered()).noneMatch(TransitionTests.Uncovered::certain);
        } while (result.answer() == Verdict.Answer.UNKNOWN);
        assertThat(reasons)
                .containsExactly(
                        "0 tests, not met so far: the time is up",
                        "0 tests, the time is up",
                        "1 tests, the time is up");
    }

    /** A configuration with many inputs costs as much as several. */
    @Test
    void inputsCountAsStates() {
        Promise promise =
                promise(
                        """
                        component C {
                          port in Integer[0..190] x, out Integer[0..190] y;
                          <<completion = "ignore">> automaton {
                            state a, b, c, d;
                            initial a;
                            a -> b {x == ?} / {y = x};
                            b -> c {x == ?} / {y = x};
                            c -> d {x == ?} / {y = x};
                          }
                        }
                        """);
        assertThat(stopped(promise, 9)).isEmpty();
        assertThat(stopped(promise, 8)).contains("more than 8 states");
    }

    private static Optional<String> stopped(Promise promise, long states) {
        return TransitionTests.of(promise, "Tests", new Budget(() -> false, states)).stopped();
    }

    private static Stream<String> text(Component component) {
        List<Value> arguments =
                Collections.nCopies(component.parameters().size(), new Value.IntegerValue(3));
        Promise promise = Promise.of(component, arguments);
        TransitionTests.Result result =
                TransitionTests.of(promise, "Tests", new Budget(() -> false, 20_000));
        return Stream.of(
                        Stream.of(component.name() + text(result)),
                        result.tests().stream().map(CoverageTest::text),
                        result.uncovered().stream()
                                .map(
                                        each ->
                                                move(each.transition())
                                                        + sure(each.certain())
                                                        + each.reason()),
                        result.gaps().stream()
                                .map(
                                        each ->
                                                move(each.transition())
                                                        + " "
                                                        + each.words()
                                                        + sure(each.certain())
                                                        + each.reason()))
                .flatMap(lines -> lines);
    }

    private static String text(TransitionTests.Result result) {
        return " %s: %d transitions, %d configurations%s"
                .formatted(
                        result.answer().name().toLowerCase(Locale.ROOT),
                        result.transitions(),
                        result.configurations(),
                        result.stopped().map(why -> ", " + why).orElse(""));
    }

    private static String sure(boolean certain) {
        return certain ? ": " : " (not certain): ";
    }

    private static String text(TransitionTests.Test test) {
        StreamTest streams = test.streams();
        return "  "
                + streams.name()
                + Stream.of(
                                test.covers().stream().map(CoverageTest::move),
                                test.tells().stream().map(CoverageTest::text),
                                Stream.of("chaos").filter(end -> !test.promised()))
                        .flatMap(words -> words)
                        .collect(Collectors.joining(", ", " (", "): "))
                + streams.inputs().stream()
                        .map(letter -> new TreeMap<>(letter.messages()).toString())
                        .collect(Collectors.joining(" "))
                + " / "
                + new TreeMap<>(streams.expected());
    }

    private static String text(Mistake mistake) {
        return move(mistake.transition()) + " " + mistake.what();
    }

    private static String move(Goal goal) {
        return goal.source() + " -> " + goal.target();
    }
}
