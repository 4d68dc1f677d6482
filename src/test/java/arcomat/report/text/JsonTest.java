package arcomat.report.text;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;

/** What models send may be half of a surrogate pair; UTF-8 would put a question mark there. */
class JsonTest {
    private static final String HALF = "\ud83e";
    private static final String ESCAPED = "\\ud83e";

    @Test
    void halfAPairIsEscapedWhereverJsonIsWritten() {
        assertThat(Json.text(HALF)).isEqualTo("\"" + ESCAPED + "\"\n");
        assertThat(Json.compact(HALF)).isEqualTo("\"" + ESCAPED + "\"\n");
    }

    @Test
    void aWholePairStaysReadable() {
        assertThat(Json.compact("\ud83e\udd16")).isEqualTo("\"\ud83e\udd16\"\n");
    }
}
