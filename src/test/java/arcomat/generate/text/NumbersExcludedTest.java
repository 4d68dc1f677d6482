package arcomat.generate.text;

import static org.assertj.core.api.Assertions.assertThat;

import arcomat.generate.language.Text;
import arcomat.model.Port;
import arcomat.model.Type;
import arcomat.model.Value;
import arcomat.source.SourceFile;
import arcomat.source.Span;

import org.junit.jupiter.api.Test;

import java.util.List;
import java.util.Optional;

/** Which comparisons of a number exclude each other: 0.0 and -0.0 are one number to them. */
class NumbersExcludedTest {
    private static final Port PORT =
            new Port(
                    "p",
                    Port.Direction.IN,
                    new Type.RealType(false),
                    true,
                    0,
                    false,
                    new Span(new SourceFile("test", ""), 0, 0));

    @Test
    void thereIsOneZero() {
        assertThat(Exclusion.contradict(is(0.0, true), is(-0.0, true))).isFalse();
        assertThat(Exclusion.contradict(is(1.0, true), is(2.0, true))).isTrue();
        assertThat(Exclusion.contradict(is(1.0, true), is(1.0, true))).isFalse();
        assertThat(Exclusion.contradict(is(1.0, true), is(1.0, false))).isTrue();
        assertThat(Exclusion.contradict(is(1.0, true), is(2.0, false))).isFalse();
    }

    @Test
    void aDifferenceIsDroppedOnlyWhereItFollows() {
        Simplification simplification = new Simplification(port -> false);
        assertThat(simplification.and(List.of(is(2.0, false), is(1.0, true))))
                .isEqualTo(is(1.0, true));
        assertThat(simplification.and(List.of(is(0.0, false), is(-0.0, true))))
                .isEqualTo(new Formula.Row(true, List.of(is(0.0, false), is(-0.0, true))));
    }

    private static Formula is(double number, boolean equal) {
        Text same = Text.primary("p == " + number);
        Text other = Text.primary("p != " + number);
        return new Formula.Is(
                PORT,
                equal,
                Optional.of(new Value.RealValue(number)),
                equal ? same : other,
                equal ? other : same);
    }
}
