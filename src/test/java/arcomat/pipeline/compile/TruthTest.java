package arcomat.pipeline.compile;

import static org.assertj.core.api.Assertions.assertThat;

import arcomat.check.Checks;
import arcomat.check.law.Profile;
import arcomat.generate.plan.Choosing;
import arcomat.lower.Lowering;
import arcomat.model.Component;
import arcomat.model.Expression;
import arcomat.model.Model;
import arcomat.model.Parameter;
import arcomat.model.StreamTest;
import arcomat.model.Type;
import arcomat.model.Value;
import arcomat.models.ModelFiles;
import arcomat.semantics.Execution;
import arcomat.simulate.run.Choice;
import arcomat.simulate.run.Interpreter;
import arcomat.simulate.run.Simulation;
import arcomat.source.Diagnostic;
import arcomat.source.SourceFile;
import arcomat.symbols.Workspace;
import arcomat.syntax.Parsed;
import arcomat.syntax.Parser;
import arcomat.translate.HouseLanguages;
import arcomat.tree.Unit;

import org.junit.jupiter.api.DynamicTest;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.TestFactory;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Set;
import java.util.TreeSet;
import java.util.stream.Stream;

/**
 * Interpreter and compiled code give the same trace: on random words over every executable model,
 * and on every stream test.
 */
class TruthTest {
    private static final int LETTERS = 50;

    /** Where some transition is taken seldom. */
    private static final int MANY_WORDS = 1000;

    private static final List<Path> ROOTS =
            List.of(Path.of("src/test/resources/truth"), Path.of("models/coffee"));

    @Tag("some-slow")
    @TestFactory
    Stream<DynamicTest> interpreterAndCompiledCodeAgree() {
        return agreement(30, false);
    }

    @Tag("slow")
    @TestFactory
    Stream<DynamicTest> interpreterAndCompiledCodeAgreeOnHundredsOfWords() {
        return agreement(100, true);
    }

    @Tag("some-slow")
    @TestFactory
    Stream<DynamicTest> interpreterAndCompiledCodeAgreeOnEveryStreamTest() {
        return models().flatMap(model -> model.tests().stream())
                .filter(test -> isExecutable(test.component()))
                .map(
                        test ->
                                DynamicTest.dynamicTest(
                                        test.component().qualifiedName() + " " + test.name(),
                                        () -> assertAgrees(test)));
    }

    /** Traces are compared, not verdicts: a test may expect a choice that is not the first. */
    private static void assertAgrees(StreamTest test) {
        Component component = test.component();
        CompiledModel compiled = CompiledModel.of(component, Choosing.FIRST);
        Execution execution = new CompiledExecution(compiled, test.arguments(), 0);
        Execution reference = new Interpreter(component, test.arguments(), Choice.first());
        assertThat(Simulation.run(execution, test.inputs()))
                .isEqualTo(Simulation.run(reference, test.inputs()));
    }

    private static Stream<DynamicTest> agreement(int words, boolean everyTransition) {
        return models().flatMap(model -> model.components().stream())
                .filter(TruthTest::isExecutable)
                .map(
                        component ->
                                DynamicTest.dynamicTest(
                                        component.qualifiedName(),
                                        () -> assertAgrees(component, words, everyTransition)));
    }

    private static void assertAgrees(Component component, int words, boolean everyTransition) {
        Agreement agreement = new Agreement(component, arguments(component)).holds(words, LETTERS);
        if (everyTransition) {
            Set<String> transitions = transitionsOf(component);
            if (!agreement.transitionsTaken().containsAll(transitions)) {
                agreement.holds(MANY_WORDS, LETTERS);
            }
            assertThat(agreement.transitionsTaken()).containsAll(transitions);
        }
    }

    /** Those of an atomic component; of the parts of a network each is run by itself. */
    private static Set<String> transitionsOf(Component component) {
        Set<String> all = new TreeSet<>();
        if (component.body() instanceof Component.Atomic atomic) {
            int count = atomic.automata().get(0).transitions().size();
            for (int i = 0; i < count; i++) {
                all.add("#" + i);
            }
        }
        return all;
    }

    private static Stream<Model> models() {
        return ROOTS.stream().map(TruthTest::model);
    }

    private static Model model(Path root) {
        Workspace workspace =
                Workspace.of(
                        ModelFiles.of(root).stream().map(TruthTest::unit).toList(),
                        Set.of(),
                        HouseLanguages.reader());
        List<Diagnostic> errors =
                Checks.run(workspace, Profile.REQUIREMENTS).stream()
                        .filter(Diagnostic::isError)
                        .toList();
        assertThat(errors).isEmpty();
        return Lowering.lower(workspace);
    }

    private static Unit unit(SourceFile file) {
        Parsed parsed = Parser.parse(file);
        assertThat(parsed.findings()).isEmpty();
        return parsed.unit().orElseThrow();
    }

    /** What the executable profile asks for, as far as it is a matter of the component. */
    private static boolean isExecutable(Component component) {
        if (component.platform()) {
            return false;
        }
        if (component.body() instanceof Component.Composite composite) {
            return !(composite.parts().isEmpty() && composite.connections().isEmpty())
                    && composite.parts().stream()
                            .map(Component.Part::component)
                            .allMatch(part -> part.platform() || isExecutable(part));
        }
        List<?> automata = ((Component.Atomic) component.body()).automata();
        return automata.size() == 1
                && ((Component.Atomic) component.body()).automata().get(0).initials().size() == 1;
    }

    private static List<Value> arguments(Component component) {
        List<Value> arguments = new ArrayList<>();
        for (Parameter parameter : component.parameters()) {
            arguments.add(
                    parameter
                            .initial()
                            .filter(Expression.Constant.class::isInstance)
                            .map(initial -> ((Expression.Constant) initial).value())
                            .orElseGet(() -> sample(parameter.type())));
        }
        return arguments;
    }

    /** A number that lets the thresholds of the models be crossed both ways. */
    private static Value sample(Type type) {
        return type instanceof Type.IntegerType ? new Value.IntegerValue(3) : type.first();
    }
}
