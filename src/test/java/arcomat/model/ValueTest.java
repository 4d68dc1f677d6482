package arcomat.model;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;

class ValueTest {
    @Test
    void textsCanBeReadAgainOnOneLine() {
        assertThat(new Value.StringValue("a\"b\\c\nd\u0001'"))
                .hasToString("\"a\\\"b\\\\c\\nd\\u0001'\"");
        assertThat(new Value.CharacterValue('\'')).hasToString("'\\''");
        assertThat(new Value.CharacterValue('"')).hasToString("'\"'");
        assertThat(new Value.CharacterValue((char) 0)).hasToString("'\\u0000'");
    }
}
