package arcomat.agent.tool;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import arcomat.pipeline.WrongUse;

import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.constraints.IntRange;

import org.junit.jupiter.api.Test;

import java.util.List;

class LongAnswersTest {
    @Property(tries = 500)
    void partsAreTheWholeAndNoneIsTooLong(
            @ForAll String text, @ForAll @IntRange(min = 2, max = 40) int longest) {
        List<String> parts = LongAnswers.parts(text, longest);
        assertThat(String.join("", parts)).isEqualTo(text);
        assertThat(parts).allSatisfy(part -> assertThat(part).hasSizeLessThanOrEqualTo(longest));
    }

    @Test
    void aPartEndsBehindALineWhereOneEndsLate() {
        assertThat(LongAnswers.parts("one\ntwo\nthree\n", 9))
                .containsExactly("one\ntwo\n", "three\n");
        assertThat(LongAnswers.parts("a\nbcdefghij", 9)).containsExactly("a\nbcdefgh", "ij");
    }

    @Test
    void noPartEndsWithinACharacter() {
        String pair = new String(Character.toChars(0x1F916));
        assertThat(LongAnswers.parts("abc" + pair + "d", 4)).containsExactly("abc", pair + "d");
    }

    @Test
    void theLastAnswersAreKept() throws WrongUse {
        LongAnswers answers = new LongAnswers(2);
        for (int i = 0; i < 9; i++) {
            answers.begin(new ToolAnswer("abc"));
        }
        assertThat(answers.part(2, 2).text()).isEqualTo("c");
        assertThatThrownBy(() -> answers.part(1, 2))
                .isInstanceOf(WrongUse.class)
                .hasMessageContaining("not kept any more");
    }
}
