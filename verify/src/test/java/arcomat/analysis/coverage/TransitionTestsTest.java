package arcomat.analysis.coverage;

import static org.assertj.core.api.Assertions.assertThat;

import arcomat.analysis.RandomSketches;
import arcomat.analysis.Sketch;
import arcomat.analysis.refinement.Verdict;
import arcomat.analysis.search.Budget;
import arcomat.check.Checks;
import arcomat.check.law.Profile;
import arcomat.lower.Lowering;
import arcomat.model.Automaton;
import arcomat.model.Component;
import arcomat.model.Model;
import arcomat.model.Parameter;
import arcomat.model.StreamTest;
import arcomat.model.Type;
import arcomat.model.Value;
import arcomat.models.ModelFiles;
import arcomat.models.ReadModels;
import arcomat.semantics.Promise;
import arcomat.simulate.test.StreamTestResult;
import arcomat.simulate.test.StreamTests;
import arcomat.simulate.test.SuiteText;
import arcomat.source.Diagnostic;
import arcomat.source.SourceFile;
import arcomat.symbols.Scenario;
import arcomat.symbols.Workspace;
import arcomat.syntax.Parsed;
import arcomat.syntax.Parser;
import arcomat.translate.HouseLanguages;
import arcomat.tree.Unit;

import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.Tag;

import org.junit.jupiter.api.DynamicTest;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.TestFactory;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.Random;
import java.util.Set;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.stream.Stream;

/** Tests that take every transition are read, checked and passed. */
class TransitionTestsTest {
    static final Path COFFEE = Path.of("models/coffee");
    static final Budget BUDGET = new Budget(() -> false, 20_000);

    /** So often a search asks whether it shall end, before it has to; then it has many tests. */
    private static final int ENOUGH = 300_000;

    /** Each port of each transition is a mistake of its own: wider ones are for the generator. */
    private static final int MOST_INPUTS = 50;

    private static TransitionTests.Result tests(Component component, List<Value> arguments) {
        return TransitionTests.of(Promise.of(component, arguments), "Transitions", BUDGET);
    }

    static TransitionTests.Result tests(Component component) {
        return tests(component, List.of());
    }

    static List<StreamTest> streams(TransitionTests.Result result) {
        return result.tests().stream().map(TransitionTests.Test::streams).toList();
    }

    /** Wherever it is stopped, also in the middle of a test: then that test takes nothing. */
    @Test
    void eachTransitionIsTakenOrNamed() {
        Component figure =
                model(COFFEE, Optional.empty()).component("coffee.fig3.AvoidCrash").orElseThrow();
        Promise promise = Promise.of(figure, List.of());
        int stopped = 0;
        for (int most = 0; most < 200; most++) {
            AtomicInteger left = new AtomicInteger(most);
            Budget little = new Budget(() -> left.decrementAndGet() < 0, 20_000);
            TransitionTests.Result result = TransitionTests.of(promise, "Little", little);
            long taken = result.tests().stream().mapToLong(each -> each.covers().size()).sum();
            assertThat(taken + result.uncovered().size())
                    .as("after %d questions", most)
                    .isEqualTo(result.transitions());
            stopped += result.answer() == Verdict.Answer.UNKNOWN ? 1 : 0;
        }
        assertThat(stopped).isBetween(3, 199);
    }

    @Test
    void fewTestsOfFewSlices() {
        Component figure =
                model(COFFEE, Optional.empty()).component("coffee.fig3.AvoidCrash").orElseThrow();
        TransitionTests.Result result = tests(figure);
        List<TransitionTests.Test> promised =
                result.tests().stream().filter(TransitionTests.Test::promised).toList();
        assertThat(text(figure, List.of(), promised))
                .isEqualTo(
                        """
                        package coffee.fig3;

                        testsuite Transitions for AvoidCrash {
                          // driving -> sidestep
                          test drivingToSidestep {
                            input {
                              frontUS: <tooClose, Tk>;
                            }
                            expect {
                              cmd: <fwd, Tk, backRight, Tk>;
                            }
                          }

                          // driving -> waiting, waiting -> driving
                          test drivingToWaiting {
                            input {
                              frontUS: <tooClose, Tk, clear, Tk>;
                            }
                            expect {
                              cmd: <fwd, Tk, stop, Tk, fwd, Tk>;
                            }
                          }
                        }
                        """);
    }

    @Test
    void withoutTimeNothingIsCertain() {
        Component figure =
                model(COFFEE, Optional.empty()).component("coffee.fig3.AvoidCrash").orElseThrow();
        Budget none = new Budget(() -> true, 1000);
        TransitionTests.Result result =
                TransitionTests.of(Promise.of(figure, List.of()), "Transitions", none);
        assertThat(result.tests()).isEmpty();
        assertThat(result.uncovered()).hasSize(3).noneMatch(TransitionTests.Uncovered::certain);
        assertThat(result.answer()).isEqualTo(Verdict.Answer.UNKNOWN);
    }

    @org.junit.jupiter.api.Tag("some-slow")
    @TestFactory
    Stream<DynamicTest> theTextIsReadCheckedAndPassed() {
        return model(COFFEE, Optional.empty()).components().stream()
                .filter(TransitionTestsTest::isAtomic)
                .map(
                        component ->
                                DynamicTest.dynamicTest(
                                        component.qualifiedName(), () -> isFine(component)));
    }

    private static void isFine(Component component) {
        List<Value> arguments =
                component.parameters().stream().map(TransitionTestsTest::sample).toList();
        TransitionTests.Result result = tests(component, arguments);
        assertThat(result.uncovered()).isEmpty();
        String path = component.packageName().replace('.', '/') + "/Transitions.mt";
        SourceFile suite = new SourceFile(path, text(component, arguments, result.tests()));
        List<StreamTest> read =
                model(COFFEE, Optional.of(suite)).tests().stream()
                        .filter(test -> test.suite().endsWith("Transitions"))
                        .toList();
        assertThat(read).hasSameSizeAs(result.tests());
        assertThat(read.stream().map(test -> StreamTests.run(test).verdict()))
                .as(suite.text())
                .containsExactlyElementsOf(
                        result.tests().stream().map(TransitionTestsTest::passes).toList());
    }

    private static Value sample(Parameter parameter) {
        return parameter.type() instanceof Type.IntegerType
                ? new Value.IntegerValue(3)
                : parameter.type().first();
    }

    /** Events, tables, conversions, all types: the models on which the generator is tried. */
    @org.junit.jupiter.api.Tag("some-slow")
    @TestFactory
    Stream<DynamicTest> modelsOfEveryKindPassTheirTests() {
        return Scenario.in("agreement").stream()
                .map(file -> Scenario.read(file).workspace())
                .flatMap(
                        workspace ->
                                Lowering.lower(workspace).components().stream()
                                        .filter(TransitionTestsTest::isAtomic)
                                        .filter(each -> each.inputs().size() <= MOST_INPUTS)
                                        .filter(TransitionTestsTest::hasFewWays)
                                        .filter(component -> !component.name().contains("<"))
                                        .map(
                                                component ->
                                                        DynamicTest.dynamicTest(
                                                                component.qualifiedName(),
                                                                () ->
                                                                        passes(
                                                                                component,
                                                                                workspace))));
    }

    private static void passes(Component component, Workspace workspace) {
        List<Value> arguments =
                component.parameters().stream().map(TransitionTestsTest::sample).toList();
        AtomicInteger left = new AtomicInteger(ENOUGH);
        Budget budget = new Budget(() -> left.decrementAndGet() < 0, 20_000);
        TransitionTests.Result result =
                TransitionTests.of(Promise.of(component, arguments), "Transitions", budget);
        assertThat(result.tests()).isNotEmpty();
        String text = text(component, arguments, result.tests());
        String folder = component.packageName().replace('.', '/');
        Parsed parsed = Parser.parse(new SourceFile(folder + "/Transitions.mt", text));
        assertThat(parsed.findings()).as(text).isEmpty();
        List<Unit> units = new ArrayList<>(workspace.units());
        units.add(parsed.unit().orElseThrow());
        List<StreamTest> read =
                checked(Workspace.of(units, Set.of(), HouseLanguages.reader())).tests().stream()
                        .filter(test -> test.suite().endsWith("Transitions"))
                        .toList();
        assertThat(read.stream().map(test -> StreamTests.run(test).verdict()))
                .as(text)
                .containsExactlyElementsOf(
                        result.tests().stream().map(TransitionTestsTest::passes).toList());
    }

    /** Of more ways than transitions, the conditions of the joined ones take minutes to solve. */
    private static boolean hasFewWays(Component component) {
        return component.automata().stream()
                .flatMap(automaton -> automaton.transitions().stream())
                .allMatch(each -> each.body().map(Automaton.Body::isNumbered).orElse(true));
    }

    private static boolean isAtomic(Component component) {
        return !component.platform()
                && component.body() instanceof Component.Atomic atomic
                && !atomic.automata().isEmpty();
    }

    /**
     * State 0 is initial, and every trigger can come: what the edges reach is what can be taken.
     */
    @Tag("slow")
    @Property(tries = 40, seed = "1")
    void allThatCanBeTakenIsTakenAndPasses(@ForAll long seed) {
        Random random = new Random(seed);
        Sketch sketch = RandomSketches.of(RandomSketches.any(random), random);
        Component component = sketch.component("Random");
        TransitionTests.Result result = tests(component);
        int[] depths = sketch.depths();
        Set<Integer> unreachable = new java.util.TreeSet<>();
        for (int i = 0; i < sketch.edges().size(); i++) {
            if (depths[sketch.edges().get(i).source()] > sketch.states()) {
                unreachable.add(i);
            }
        }
        assertThat(result.uncovered().stream().map(each -> each.transition().index()))
                .containsExactlyElementsOf(unreachable);
        assertThat(result.stopped()).isEmpty();
        int covered = result.tests().stream().mapToInt(test -> test.covers().size()).sum();
        assertThat(covered).isEqualTo(sketch.edges().size() - unreachable.size());
        assertThat(verdicts(streams(result), component))
                .isEqualTo(result.tests().stream().map(TransitionTestsTest::passes).toList());
    }

    /** Where nothing is promised any more, a test passes vacuously. */
    static StreamTestResult.Verdict passes(TransitionTests.Test test) {
        return test.promised() ? StreamTestResult.Verdict.PASSED : StreamTestResult.Verdict.VACUOUS;
    }

    /** Against what a model of the same ports allows. */
    static List<StreamTestResult.Verdict> verdicts(List<StreamTest> tests, Component component) {
        return tests.stream()
                .map(
                        test ->
                                new StreamTest(
                                        test.suite(),
                                        test.name(),
                                        component,
                                        test.arguments(),
                                        test.inputs(),
                                        test.expected(),
                                        test.span()))
                .map(test -> StreamTests.run(test).verdict())
                .toList();
    }

    private static String text(
            Component component, List<Value> arguments, List<TransitionTests.Test> tests) {
        List<SuiteText.Entry> entries = new ArrayList<>();
        for (TransitionTests.Test test : tests) {
            String covers =
                    String.join(
                            ", ",
                            test.covers().stream()
                                    .map(goal -> goal.source() + " -> " + goal.target())
                                    .toList());
            entries.add(new SuiteText.Entry(List.of(covers), test.streams()));
        }
        return SuiteText.of("Transitions", component, arguments, List.of(), entries);
    }

    static Model model(Path folder, Optional<SourceFile> more) {
        List<SourceFile> sources = new ArrayList<>(ModelFiles.of(folder));
        more.ifPresent(sources::add);
        return checked(ReadModels.workspace(sources));
    }

    private static Model checked(Workspace workspace) {
        assertThat(Checks.run(workspace, Profile.REQUIREMENTS).stream().filter(Diagnostic::isError))
                .isEmpty();
        return Lowering.lower(workspace);
    }
}
