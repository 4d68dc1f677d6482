package arcomat.analysis.coverage;

import static org.assertj.core.api.Assertions.assertThat;

import arcomat.analysis.RandomSketches;
import arcomat.analysis.RandomSketches.Knobs;
import arcomat.analysis.Sketch;
import arcomat.analysis.Sketch.Edge;
import arcomat.analysis.refinement.Refinement;
import arcomat.analysis.refinement.Verdict;
import arcomat.model.Automaton;
import arcomat.model.Automaton.Completion;
import arcomat.model.Component;
import arcomat.model.Expression;
import arcomat.model.Model;
import arcomat.model.StreamTest;
import arcomat.model.Type;
import arcomat.model.Value;
import arcomat.semantics.Promise;
import arcomat.simulate.run.Choice;
import arcomat.simulate.run.Interpreter;
import arcomat.simulate.test.ExecutedTests;
import arcomat.simulate.test.StreamTestResult;

import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.Tag;

import org.junit.jupiter.api.DynamicTest;
import org.junit.jupiter.api.TestFactory;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.Random;
import java.util.stream.Stream;

/** Tests that take every transition notice what is changed. */
class TransitionMutantsTest {
    private static TransitionTests.Result tests(Component component) {
        return TransitionTestsTest.tests(component);
    }

    private static List<StreamTest> streams(TransitionTests.Result result) {
        return TransitionTestsTest.streams(result);
    }

    private static List<StreamTestResult.Verdict> verdicts(
            List<StreamTest> tests, Component component) {
        return TransitionTestsTest.verdicts(tests, component);
    }

    /** Of automata in which each letter has at most one transition. */
    private static Sketch decided(Random random) {
        Knobs knobs = RandomSketches.any(random).withAlternatives(0);
        return RandomSketches.of(knobs, random);
    }

    @Tag("slow")
    @Property(tries = 20, seed = "2")
    void whoSendsSomethingElseFails(@ForAll long seed) {
        Random random = new Random(seed);
        Sketch sketch = decided(random);
        TransitionTests.Result result = tests(sketch.component("Random"));
        for (Edge edge : covered(sketch, result)) {
            Edge changed = sendingAnother(edge, sketch, random);
            if (isSaid(edge) && !changed.equals(edge)) {
                Component mutant = sketch.replacing(edge, changed).component("Random");
                assertThat(verdicts(streams(result), mutant))
                        .contains(StreamTestResult.Verdict.FAILED);
            }
        }
    }

    /** A model that says less allows what was asked for; only what runs can miss it. */
    @Tag("slow")
    @Property(tries = 20, seed = "3")
    void whoDropsATransitionThatSendsFails(@ForAll long seed) {
        Random random = new Random(seed);
        Sketch sketch = decided(random);
        TransitionTests.Result result = tests(sketch.component("Random"));
        for (Edge edge : covered(sketch, result)) {
            boolean isFirst = sketch.shape().totalOut() && edge.output().contains("x0");
            if (isSaid(edge) && !isFirst) {
                Component mutant = sketch.replacing(edge).component("Random");
                assertThat(verdictsOfRuns(streams(result), mutant))
                        .contains(StreamTestResult.Verdict.FAILED);
                if (sketch.completion() == Completion.CHAOS) {
                    assertThat(verdicts(streams(result), mutant))
                            .contains(StreamTestResult.Verdict.VACUOUS);
                } else if (sketch.completion() != Completion.OUTPUT) {
                    assertThat(verdicts(streams(result), mutant))
                            .contains(StreamTestResult.Verdict.FAILED);
                }
            }
        }
    }

    /** Where inputs are ignored, one more or less transition shows in the end, if it ever does. */
    @Tag("slow")
    @Property(tries = 20, seed = "4")
    void whoDropsASilentTransitionFailsLater(@ForAll long seed) {
        Random random = new Random(seed);
        Knobs knobs = RandomSketches.any(random).withAlternatives(0);
        Sketch sketch = RandomSketches.of(knobs.withCompletion(Completion.IGNORE), random);
        if (sketch.shape().totalOut() || sketch.shape().free()) {
            return;
        }
        Component component = sketch.component("Random");
        TransitionTests.Result result = tests(component);
        for (Edge edge : covered(sketch, result)) {
            Component mutant = sketch.replacing(edge).component("Random");
            boolean same =
                    Refinement.check(
                                            Promise.of(component, List.of()),
                                            Promise.of(mutant, List.of()),
                                            TransitionTestsTest.BUDGET)
                                    .answer()
                            == Verdict.Answer.HOLDS;
            assertThat(verdicts(streams(result), mutant).contains(StreamTestResult.Verdict.FAILED))
                    .isNotEqualTo(same);
        }
    }

    /** The figures of the paper: without a transition, and with another output of one. */
    @TestFactory
    Stream<DynamicTest> changedFiguresFail() {
        Model coffee = TransitionTestsTest.model(TransitionTestsTest.COFFEE, Optional.empty());
        return Stream.of("fig3", "fig5", "fig6")
                .map(name -> coffee.component("coffee." + name + ".AvoidCrash").orElseThrow())
                .map(
                        figure ->
                                DynamicTest.dynamicTest(
                                        figure.qualifiedName(), () -> mutantsFail(figure)));
    }

    private static void mutantsFail(Component figure) {
        List<StreamTest> tests = streams(tests(figure));
        List<Automaton.Transition> transitions = figure.automata().get(0).transitions();
        for (int i = 0; i < transitions.size(); i++) {
            List<Automaton.Transition> fewer = new ArrayList<>(transitions);
            Automaton.Transition transition = fewer.remove(i);
            List<StreamTestResult.Verdict> without = verdicts(tests, with(figure, fewer));
            assertThat(without)
                    .containsAnyOf(
                            StreamTestResult.Verdict.FAILED, StreamTestResult.Verdict.VACUOUS);
            if (figure.automata().get(0).completion() == Completion.IGNORE) {
                assertThat(without).contains(StreamTestResult.Verdict.FAILED);
            }
            for (Automaton.Transition changed : sendingAnother(transition)) {
                List<Automaton.Transition> others = new ArrayList<>(transitions);
                others.set(i, changed);
                assertThat(verdicts(tests, with(figure, others)))
                        .as(changed.toString())
                        .contains(StreamTestResult.Verdict.FAILED);
            }
        }
    }

    /** Each message in turn is lost, or is another constant of its type. */
    private static List<Automaton.Transition> sendingAnother(Automaton.Transition transition) {
        List<Automaton.Transition> changed = new ArrayList<>();
        for (int i = 0; i < transition.sends().size(); i++) {
            Automaton.Send send = transition.sends().get(i);
            Type.EnumType type = (Type.EnumType) send.port().type();
            List<Automaton.Emission> others = new ArrayList<>(List.of(new Automaton.Silence()));
            for (int k = 0; k < type.constants().size(); k++) {
                Value value = new Value.EnumValue(type, k);
                Expression constant = new Expression.Constant(value, type, transition.span());
                Automaton.Messages messages = (Automaton.Messages) send.emission();
                Expression.Constant sent = (Expression.Constant) messages.values().get(0);
                if (!sent.value().equals(value)) {
                    others.add(new Automaton.Messages(List.of(constant)));
                }
            }
            for (Automaton.Emission other : others) {
                List<Automaton.Send> sends = new ArrayList<>(transition.sends());
                sends.set(i, new Automaton.Send(send.port(), other));
                changed.add(
                        transition.with(
                                transition.guard(),
                                transition.matches(),
                                sends,
                                transition.assignments()));
            }
        }
        return changed;
    }

    private static Component with(Component figure, List<Automaton.Transition> transitions) {
        return with(figure, figure.automata().get(0).withTransitions(transitions));
    }

    static Component with(Component figure, Automaton changed) {
        return new Component(
                figure.packageName(),
                figure.name(),
                figure.layer(),
                figure.platform(),
                figure.deploy(),
                figure.profile(),
                figure.queueCapacity(),
                figure.cycle(),
                figure.parameters(),
                figure.constants(),
                figure.ports(),
                new Component.Atomic(List.of(changed)),
                figure.requirements(),
                figure.refines(),
                List.of(),
                figure.span());
    }

    private static boolean isSaid(Edge edge) {
        return edge.output().contains("out = x");
    }

    /** The same edge where there is nothing else to send. */
    private static Edge sendingAnother(Edge edge, Sketch sketch, Random random) {
        String answer = "out = x" + random.nextInt(sketch.shape().answers());
        boolean silence = edge.output().contains(answer) && !sketch.shape().totalOut();
        return edge.sending(
                edge.output().replaceFirst("out = x[0-9]", silence ? "out = --" : answer));
    }

    private static List<Edge> covered(Sketch sketch, TransitionTests.Result result) {
        return result.tests().stream()
                .flatMap(test -> test.covers().stream())
                .map(goal -> sketch.edges().get(goal.index()))
                .toList();
    }

    /** Against a program that takes first choices. */
    private static List<StreamTestResult.Verdict> verdictsOfRuns(
            List<StreamTest> tests, Component component) {
        return tests.stream()
                .map(
                        test ->
                                ExecutedTests.run(
                                                test,
                                                new Interpreter(
                                                        component, List.of(), Choice.first()))
                                        .verdict())
                .toList();
    }
}
