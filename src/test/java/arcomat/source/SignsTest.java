package arcomat.source;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;

import java.util.stream.IntStream;

class SignsTest {
    @Test
    void namesWhatIsNotSeen() {
        assertThat(Signs.quoted(0xA0)).isEqualTo("'\\u00a0' (no-break space)");
        assertThat(Signs.quoted(0x301)).isEqualTo("'\\u0301' (combining mark)");
        assertThat(Signs.quoted(0xD83E)).isEqualTo("'\\ud83e' (half of a character)");
        assertThat(Signs.quoted(0x1F916)).isEqualTo("'🤖'");
    }

    /** Java calls blanks separators, and each has a name here. */
    @Test
    void knowsAllBlanks() {
        assertThat(
                        IntStream.rangeClosed(0x80, Character.MAX_CODE_POINT)
                                .filter(Character::isSpaceChar))
                .allMatch(Signs::isBlank);
    }

    @Test
    void escapesWhatChangesTheDirection() {
        assertThat(Signs.withoutDirections("a\u202eb\u2066")).isEqualTo("a\\u202eb\\u2066");
        assertThat(Signs.withoutDirections("שלום")).isEqualTo("שלום");
    }
}
