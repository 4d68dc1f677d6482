package arcomat.generate;

import static org.assertj.core.api.Assertions.assertThat;

import arcomat.generate.view.AssignmentView;
import arcomat.generate.view.FieldView;
import arcomat.generate.view.TransitionView;

import org.junit.jupiter.api.Test;

import java.util.Collections;
import java.util.List;

/** Virtual machines want small methods: how large they are, and where they are cut. */
class SizesTest {
    private static TransitionView transition(String condition, int messages, int assignments) {
        AssignmentView some = new AssignmentView("field", "this.other + 1");
        return new TransitionView(
                0,
                "",
                condition,
                List.of(new FieldView("int", "local", "a", "")),
                Collections.nCopies(messages, some),
                Collections.nCopies(assignments, some),
                "t");
    }

    @Test
    void namesWithTheirQualifiersAndNumbersAreWords() {
        assertThat(MethodSize.words("LightCode.RED == light && n<=12")).isEqualTo(4);
        assertThat(MethodSize.words("")).isZero();
    }

    @Test
    void eachWordOfATransitionCounts() {
        int bare = MethodSize.of(transition("", 0, 0));
        assertThat(MethodSize.of(transition("a && b", 0, 0)) - bare).isEqualTo(2 * 8);
        assertThat(MethodSize.of(transition("", 2, 0)) - bare).isEqualTo(2 * 3 * 8);
        assertThat(MethodSize.of(transition("", 0, 2)) - bare).isEqualTo(2 * 3 * 8);
    }

    @Test
    void transitionsAreSplitBeforeAMethodGetsTooLarge() {
        TransitionView large = transition("a ".repeat(240), 0, 0); // some 1,950 bytes
        List<TransitionView> many = Collections.nCopies(7, large);
        assertThat(MethodSize.fits(many)).isFalse();
        assertThat(MethodSize.split(many)).extracting(List::size).containsExactly(3, 3, 1);
        assertThat(MethodSize.split(many)).allMatch(MethodSize::fits);
        TransitionView huge = transition("a ".repeat(2400), 0, 0);
        assertThat(MethodSize.split(List.of(huge, huge))).hasSize(2);
    }
}
