package arcomat.symbols.names;

import static org.assertj.core.api.Assertions.assertThat;

import arcomat.source.SourceFile;
import arcomat.source.Span;
import arcomat.tree.Expression.Literal;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

import java.util.Random;

/** Hexadecimal floating point literals are what Java reads. */
class LiteralValuesTest {
    @ParameterizedTest
    @ValueSource(
            strings = {
                "0x1p3",
                "0x1.8p-2",
                "0X.8P1",
                "0x1p-1074",
                "0x1p-1075",
                "0x1.8p-1075",
                "0x1.fffffffffffff8p1023",
                "0x1p1024",
                "0x0p5",
                "0x1p+3d",
                "0x1p99999999999",
                "0xffffffffffffffffffffp-99999999999"
            })
    void ofOneText(String text) {
        assertThat(read(text, Literal.Kind.DOUBLE)).isEqualTo(Double.parseDouble(shortened(text)));
    }

    @Test
    void ofRandomTexts() {
        Random random = new Random(1);
        for (int i = 0; i < 2_000; i++) {
            String text =
                    "0x%x.%xp%d"
                            .formatted(
                                    random.nextInt(1 << 20),
                                    random.nextLong() >>> random.nextInt(64),
                                    random.nextInt(2_300) - 1_150);
            assertThat(read(text, Literal.Kind.DOUBLE))
                    .as(text)
                    .isEqualTo(Double.parseDouble(text));
            assertThat((float) read(text + "f", Literal.Kind.FLOAT))
                    .as(text)
                    .isEqualTo(Float.parseFloat(text));
        }
    }

    /** Java's own reader takes exponents of an int. */
    private static String shortened(String text) {
        return text.replace("99999999999", "999999");
    }

    private static double read(String text, Literal.Kind kind) {
        Span span = new Span(new SourceFile("A.arc", text), 0, text.length());
        return LiteralValues.realNumber(new Literal(span, kind, text));
    }
}
