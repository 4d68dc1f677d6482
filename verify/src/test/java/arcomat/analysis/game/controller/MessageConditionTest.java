package arcomat.analysis.game.controller;

import static org.assertj.core.api.Assertions.assertThat;

import arcomat.model.Automaton;
import arcomat.model.Component;
import arcomat.model.Port;
import arcomat.model.Type;
import arcomat.model.Value;
import arcomat.semantics.ComponentBuilder;
import arcomat.semantics.automaton.ComponentSemantics;
import arcomat.semantics.automaton.Input;
import arcomat.semantics.automaton.StepRelation;
import arcomat.semantics.value.InputAbstraction.Compared;

import org.junit.jupiter.api.Test;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import java.util.stream.IntStream;

/** Whatever kinds of messages are wanted: the condition is true for these and no others. */
class MessageConditionTest {
    @Test
    void whatIsNoNumberIsToldFromNumbers() {
        Type type = new Type.RealType(false);
        List<Value> samples = new ArrayList<>();
        samples.add(null);
        for (double number : new double[] {1, 3, 0, 2, Double.POSITIVE_INFINITY, Double.NaN}) {
            samples.add(new Value.RealValue(number));
        }
        checkAll(type, new Compared(samples.subList(1, 3), true), samples);
    }

    @Test
    void numbersOfARange() {
        List<Value> samples = new ArrayList<>();
        samples.add(null);
        for (long number : new long[] {2, 5, 0, 3, 6}) {
            samples.add(new Value.IntegerValue(number));
        }
        Type type = ComponentBuilder.range(0, 9);
        checkAll(type, new Compared(samples.subList(1, 3), true), samples);
        List<Value> unordered = new ArrayList<>(samples.subList(0, 4));
        checkAll(type, new Compared(samples.subList(1, 3), false), unordered);
    }

    private static void checkAll(Type type, Compared look, List<Value> samples) {
        for (int mask = 1; mask < (1 << samples.size()) - 1; mask++) {
            int wanted = mask;
            check(
                    type,
                    look,
                    samples,
                    IntStream.range(0, samples.size())
                            .filter(i -> (wanted >> i & 1) == 1)
                            .toArray());
        }
    }

    private static void check(Type type, Compared look, List<Value> samples, int[] group) {
        ComponentBuilder builder = ComponentBuilder.component("C").in(type, "x");
        Port port = builder.port("x");
        MessageCondition condition = new MessageCondition(port, look, samples, group);
        Component component =
                builder.automaton(Automaton.Completion.IGNORE, "s").initial("s", "").build();
        Automaton alone = component.automata().get(0);
        boolean matches = condition.match().isPresent();
        Automaton.Transition transition =
                new Automaton.Transition(
                        0,
                        0,
                        matches ? Optional.empty() : Optional.of(condition.guard()),
                        condition.match().map(List::of).orElse(List.of()),
                        List.of(),
                        List.of(),
                        ComponentBuilder.NOWHERE);
        Automaton automaton =
                new Automaton(
                        "",
                        alone.completion(),
                        alone.omitted(),
                        alone.states(),
                        List.of(),
                        alone.initials(),
                        List.of(transition),
                        ComponentBuilder.NOWHERE);
        StepRelation relation =
                ComponentSemantics.of(component, List.of(automaton), List.of()).relations().get(0);
        for (int i = 0; i < samples.size(); i++) {
            Input input = Input.of(new Value[] {samples.get(i)});
            boolean enabled =
                    !relation.enabled(relation.starts().get(0).configuration(), input).isEmpty();
            int sample = i;
            assertThat(enabled)
                    .as("%s of %s: %s", Arrays.toString(group), samples, transition)
                    .isEqualTo(Arrays.stream(group).anyMatch(each -> each == sample));
        }
    }
}
