package arcomat.analysis.search.letter;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import arcomat.lower.Lowering;
import arcomat.model.Component;
import arcomat.model.Port;
import arcomat.semantics.value.InputAbstraction;
import arcomat.semantics.value.InputAbstraction.PortAbstraction;
import arcomat.semantics.value.TooManyMessages;
import arcomat.symbols.Scenario;

import org.junit.jupiter.api.Test;

import java.util.Arrays;
import java.util.Collections;
import java.util.List;
import java.util.Objects;
import java.util.stream.Collectors;

/** All letters, those with few messages first, as long as there are not too many. */
class LettersTest {
    private static final String PORTS =
            "port in Boolean x, in Integer[0..1] y, <<total>> in Boolean z;";

    private static Component component(String text) {
        return Lowering.lower(
                        Scenario.of(
                                        "==== a/C.arc\npackage a;\ncomponent C {\n"
                                                + text
                                                + "\n automaton { state s; initial s; } }\n")
                                .workspace())
                .component("a.C")
                .orElseThrow();
    }

    private static List<PortAbstraction> all(Component component) {
        return Collections.nCopies(component.inputs().size(), new InputAbstraction.Whole());
    }

    private static String text(List<arcomat.model.Value[]> letters) {
        return letters.stream()
                .map(
                        letter ->
                                Arrays.stream(letter)
                                        .map(each -> Objects.toString(each, "-"))
                                        .collect(Collectors.joining(" ")))
                .collect(Collectors.joining(", "));
    }

    @Test
    void aSliceMayBeSilentWhereAPortIsNotTotal() {
        Component c = component(PORTS);
        assertThat(text(Letters.of(c, new InputAbstraction(all(c)))))
                .isEqualTo(
                        "- - false, - - true, - 0 false, - 0 true, - 1 false, - 1 true,"
                                + " false - false, false - true, true - false, true - true,"
                                + " false 0 false, false 0 true, false 1 false, false 1 true,"
                                + " true 0 false, true 0 true, true 1 false, true 1 true");
    }

    @Test
    void exactlyAsManyAsAreWantedAreNotTooMany() {
        Component c = component(PORTS);
        assertThat(Letters.atMost(18, c.inputs(), all(c))).hasSize(18);
        assertThatThrownBy(() -> Letters.atMost(17, c.inputs(), all(c)))
                .isInstanceOf(TooManyMessages.class)
                .hasMessageContaining("17");
    }

    @Test
    void anEventIsOneMessageBesideWhatIsLatched() {
        Component c =
                component(
                        "timing untimed;\n"
                            + "port in Boolean x, <<state>> in Boolean held, in Integer[0..1] y;");
        assertThat(text(Letters.of(c, new InputAbstraction(all(c)))))
                .isEqualTo(
                        "false - -, true - -, - - 0, - - 1,"
                                + " false false -, false true -, true false -, true true -,"
                                + " - false 0, - true 0, - false 1, - true 1");
    }

    /** Nothing is said about silence where the right side gets a message in every slice. */
    @Test
    void whatIsTotalOnTheRightIsTotal() {
        List<Port> left = component("port in Boolean x, in Boolean y, in Boolean z;").inputs();
        List<Port> right = component("port <<total>> in Boolean x, in Boolean y;").inputs();
        assertThat(Letters.compared(left, right))
                .extracting(port -> port.name() + " " + port.total())
                .containsExactly("x true", "y false", "z false");
    }
}
