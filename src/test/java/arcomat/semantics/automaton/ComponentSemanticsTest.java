package arcomat.semantics.automaton;

import static arcomat.semantics.ComponentBuilder.BOOLEAN;
import static arcomat.semantics.ComponentBuilder.INTEGER;
import static arcomat.semantics.ComponentBuilder.component;

import static org.assertj.core.api.Assertions.assertThat;

import arcomat.model.Automaton.Completion;
import arcomat.model.Component;
import arcomat.model.Letter;
import arcomat.model.Value;
import arcomat.semantics.ComponentBuilder;
import arcomat.semantics.automaton.ComponentSemantics.JointError;
import arcomat.semantics.automaton.ComponentSemantics.Prospect;

import org.junit.jupiter.api.Test;

import java.util.List;
import java.util.Map;

/** What several automata of one component do together. */
class ComponentSemanticsTest {

    /** The first one has two alternatives to begin with, and two for each input. */
    private static Component both(Completion one, Completion two) {
        return component("Both")
                .in(BOOLEAN, "x")
                .out(BOOLEAN, "y")
                .automaton(one, "s", "t")
                .initial("s", "")
                .initial("t", "")
                .on("s -> s", "x = true", "")
                .on("s -> t", "x = true", "")
                .end()
                .automaton(two, "u", "v")
                .initial("u", "")
                .initial("v", "")
                .on("u -> u", "x = true", "")
                .on("u -> v", "x = true", "")
                .build();
    }

    private static Prospect atSilence(Component component) {
        ComponentSemantics behaviour = ComponentSemantics.of(component, List.of());
        return behaviour.prospect(
                behaviour.starts().get(0).configurations(), Input.of(component, Letter.SILENCE));
    }

    @Test
    void aRunEndsWhereEachAutomatonEndsIt() {
        Prospect prospect = atSilence(both(Completion.ERROR, Completion.ERROR));
        assertThat(prospect.reactions()).isEmpty();
        assertThat(prospect.errors())
                .extracting(JointError::message)
                .containsExactly(
                        "Both, in s: the automaton forbids this input; "
                                + "Both, in u: the automaton forbids this input");
        assertThat(prospect.errors().get(0).causes()).hasSize(2);
    }

    @Test
    void oneAutomatonAloneEndsNoRun() {
        Prospect prospect = atSilence(both(Completion.ERROR, Completion.IGNORE));
        assertThat(prospect.errors()).isEmpty();
        assertThat(prospect.isContradiction()).isTrue();
    }

    /** Alternatives multiply: whoever waits is asked before each combination. */
    @Test
    void eachCombinationAsksWhetherToGoOn() {
        Component component = both(Completion.IGNORE, Completion.IGNORE);
        ComponentSemantics behaviour = ComponentSemantics.of(component, List.of());
        int[] asked = {0};
        assertThat(behaviour.starts(() -> asked[0]++)).hasSize(4);
        assertThat(asked[0]).isEqualTo(2 + 4);
        Letter letter = Letter.of(Map.of("x", new Value.BooleanValue(true)));
        asked[0] = 0;
        behaviour.prospect(
                behaviour.starts().get(0).configurations(),
                Input.of(component, letter),
                () -> asked[0]++);
        assertThat(asked[0]).isEqualTo(2 + 4);
    }

    private static ComponentBuilder writing(int automata) {
        ComponentBuilder builder = component("C").out(INTEGER, "o").out(INTEGER, "p");
        for (int i = 0; i < automata; i++) {
            builder.automaton(Completion.OUTPUT, "s").initial("s", "o = 1").end();
        }
        return builder;
    }

    private static Component decomposed(int automata) {
        return writing(automata).part("inner", component("Inner").build()).build();
    }

    @Test
    void aSoleAutomatonDecidesAboutAllPorts() {
        Component atomic = writing(1).build();
        assertThat(ComponentSemantics.owned(atomic, atomic.automata().get(0)))
                .containsExactlyInAnyOrder("o", "p");
    }

    /** What its parts do on other ports is none of its business. */
    @Test
    void aSoleRequirementDecidesAboutWhatItWrites() {
        Component decomposed = decomposed(1);
        assertThat(ComponentSemantics.owned(decomposed, decomposed.automata().get(0)))
                .containsExactly("o");
    }

    @Test
    void whatNoRequirementWritesBelongsToAllOfThem() {
        Component decomposed = decomposed(2);
        assertThat(decomposed.automata())
                .allSatisfy(
                        automaton ->
                                assertThat(ComponentSemantics.owned(decomposed, automaton))
                                        .containsExactlyInAnyOrder("o", "p"));
    }
}
