package arcomat.pipeline.explored;

import static org.assertj.core.api.Assertions.assertThat;

import arcomat.source.Sha256;

import org.junit.jupiter.api.Test;

import java.util.Map;

/** A question is known again, and what makes it another one is said. */
class ExploredQuestionTest {
    private static final ExploredQuestion ASKED = question("1", "A refines B", "text");

    private static ExploredQuestion question(String version, String asked, String model) {
        return new ExploredQuestion(
                Sha256.hex(version),
                asked,
                Map.of("m/A.arc", Sha256.hex(model), "m/B b.arc", Sha256.hex("other")));
    }

    @Test
    void isReadAsItWasWritten() {
        assertThat(ExploredQuestion.parse(ASKED.text())).hasValue(ASKED);
        assertThat(ASKED.difference(ASKED)).isEmpty();
        assertThat(ExploredQuestion.parse("A refines B")).isEmpty();
        assertThat(ExploredQuestion.parse(ASKED.text() + "model of somebody")).isEmpty();
    }

    @Test
    void saysWhatDiffers() {
        assertThat(ASKED.difference(question("1", "A refines C", "text")))
                .hasValue("another question: A refines B");
        assertThat(ASKED.difference(question("2", "A refines B", "text")))
                .hasValue("another version of the tool");
        assertThat(ASKED.difference(question("1", "A refines B", "changed")))
                .hasValue("other models: 'm/A.arc' has changed since");
        assertThat(ASKED.difference(new ExploredQuestion(ASKED.version(), ASKED.asked(), Map.of())))
                .hasValue("other models: 'm/A.arc' is not among these any more");
        assertThat(new ExploredQuestion(ASKED.version(), ASKED.asked(), Map.of()).difference(ASKED))
                .hasValue("other models: 'm/A.arc' was not among them");
    }
}
