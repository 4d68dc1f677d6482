package arcomat.source;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;

import java.text.Normalizer;
import java.util.stream.IntStream;

class ComposedFormTest {
    /** Of every letter that names may have. */
    @Test
    void isThatOfJava() {
        IntStream.concat(IntStream.rangeClosed(0xC0, 0x2AF), IntStream.rangeClosed(0x391, 0x481))
                .mapToObj(Character::toString)
                .map(letter -> Normalizer.normalize(letter, Normalizer.Form.NFD))
                .forEach(
                        apart ->
                                assertThat(ComposedForm.of("a" + apart + "b"))
                                        .isEqualTo(
                                                Normalizer.normalize(
                                                        "a" + apart + "b", Normalizer.Form.NFC)));
    }

    @Test
    void keepsWhatHasNoOtherForm() {
        assertThat(ComposedForm.of("Café")).isEqualTo("Café");
        assertThat(ComposedForm.of("q\u0303")).isEqualTo("q\u0303");
        assertThat(ComposedForm.firstMark("q\u0303")).isEqualTo(1);
        assertThat(ComposedForm.firstMark("Café")).isNegative();
    }
}
