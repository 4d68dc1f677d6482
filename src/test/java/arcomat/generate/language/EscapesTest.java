package arcomat.generate.language;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;

import java.util.Map;

/** Texts of a model between the quotation marks of Java and of C. */
class EscapesTest {
    private static final TargetLanguage JAVA = new TargetLanguage(Map.of());
    private static final TargetLanguage C = new TargetLanguage(Map.of("escape", "c"));

    @Test
    void whatIsPlainStaysAsItIs() {
        assertThat(Escapes.string(JAVA, "a B~ 7")).isEqualTo("a B~ 7");
        assertThat(Escapes.string(C, "a B~ 7")).isEqualTo("a B~ 7");
    }

    @Test
    void marksAreMarked() {
        assertThat(Escapes.string(JAVA, "\"\\'?")).isEqualTo("\\\"\\\\'?");
        assertThat(Escapes.string(C, "\"\\'?")).isEqualTo("\\\"\\\\'\\?");
        assertThat(Escapes.character(JAVA, '\'')).isEqualTo("\\'");
        assertThat(Escapes.character(JAVA, '"')).isEqualTo("\"");
        assertThat(Escapes.character(C, 'x')).isEqualTo("x");
    }

    /** Three digits always: what follows may be a digit, too. */
    @Test
    void whatCannotBeSeenIsANumber() {
        assertThat(Escapes.string(JAVA, "\n7\u0000\u007f\u00e9\u20ac"))
                .isEqualTo("\\0127\\000\\u007f\\u00e9\\u20ac");
        assertThat(Escapes.string(C, "\n7\u0000\u007f\u00e9"))
                .isEqualTo("\\0127\\000\\177\\303\\251");
    }
}
