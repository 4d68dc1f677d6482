package arcomat.model;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;

class ValueTest {
    /** Half of a character has no place in a file. */
    @Test
    void halvesOfCharactersAreWrittenAsCodes() {
        assertThat(new Value.StringValue("\ude00\ud83d\ude00\ud83d\ud83d"))
                .hasToString("\"\\ude00\ud83d\ude00\\ud83d\\ud83d\"");
        assertThat(new Value.CharacterValue('\udc00')).hasToString("'\\udc00'");
    }

    @Test
    void textsCanBeReadAgainOnOneLine() {
        assertThat(new Value.StringValue("a\"b\\c\nd\u0001'"))
                .hasToString("\"a\\\"b\\\\c\\nd\\u0001'\"");
        assertThat(new Value.CharacterValue('\'')).hasToString("'\\''");
        assertThat(new Value.CharacterValue('"')).hasToString("'\"'");
        assertThat(new Value.CharacterValue((char) 0)).hasToString("'\\u0000'");
    }
}
