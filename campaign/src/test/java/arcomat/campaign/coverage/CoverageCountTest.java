package arcomat.campaign.coverage;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import arcomat.campaign.coverage.AutomatonItems.State;
import arcomat.campaign.coverage.AutomatonItems.Transition;

import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.constraints.IntRange;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

import java.util.BitSet;
import java.util.List;
import java.util.Set;

class CoverageCountTest {
    private static final AutomatonItems LAMP =
            new AutomatonItems(
                    "p.Lamp",
                    "p/Lamp.arc",
                    List.of(
                            new Transition(5, "off -> on", 1, true),
                            new Transition(6, "on -> off", 0, true)),
                    List.of(new State(3, "off"), new State(3, "on"), new State(3, "broken")),
                    List.of(0, 2));

    private static final AutomatonItems BELL =
            new AutomatonItems(
                    "p.Bell",
                    "p/Bell.arc",
                    List.of(new Transition(4, "idle -> idle", 0, true)),
                    List.of(new State(2, "idle")),
                    List.of(0));

    /**
     * Transitions 0 to 2, then the beginnings 3 to 5; those of one lamp from 6 and 8, of the other
     * one from 10 and 12.
     */
    private static final CoverageItems ITEMS =
            new CoverageItems(
                    List.of(LAMP, BELL),
                    List.of(
                            new PartItems("one", "lamp", 0),
                            new PartItems("one", "bell", 1),
                            new PartItems("other", "", 0)),
                    List.of());

    private static ReachedItems reached(int... numbers) {
        BitSet all = new BitSet();
        for (int number : numbers) {
            all.set(number);
        }
        return ReachedItems.of(all);
    }

    @Test
    void transitionsAreCountedAndStatesThatWereEntered() {
        CoverageCount count = new CoverageCount(ITEMS);
        count.see(reached(3, 5));
        count.see(reached(0, 3, 5));
        count.see(reached(0, 1, 2, 3, 5));
        count.see(ReachedItems.UNKNOWN);
        Coverage coverage = count.coverage();
        assertThat(coverage.runs()).isEqualTo(3);
        assertThat(coverage.automata().get(0).transitions()).containsExactly(2L, 1L);
        assertThat(coverage.automata().get(0).states()).containsExactly(3L, 2L, 0L);
        assertThat(coverage.automata().get(1).transitions()).containsExactly(1L);
        assertThat(coverage.automata().get(1).states()).containsExactly(3L);
        assertThat(coverage.taken()).isEqualTo(3);
        assertThat(coverage.visited()).isEqualTo(3);
        assertThat(coverage.states()).isEqualTo(4);
    }

    /** A bell that is the only one is what the bells have covered. */
    @Test
    void eachPartIsCountedForItself() {
        CoverageCount count = new CoverageCount(ITEMS);
        count.see(reached(0, 2, 3, 4, 5, 6, 8, 13));
        count.see(reached(0, 1, 3, 5, 6, 8, 10, 11, 12));
        List<Coverage.OfPart> parts = count.coverage().parts();
        assertThat(parts.stream().map(each -> each.part().name()))
                .containsExactly("one.lamp", "other", "one.bell");
        assertThat(parts.stream().map(Coverage.OfPart::number)).containsExactly(6, 10, 2);
        assertThat(parts.get(0).transitions()).containsExactly(2L, 0L);
        assertThat(parts.get(0).states()).containsExactly(2L, 2L, 0L);
        assertThat(parts.get(1).transitions()).containsExactly(1L, 1L);
        assertThat(parts.get(1).states()).containsExactly(1L, 1L, 1L);
        assertThat(parts.get(2).transitions()).containsExactly(1L);
        assertThat(parts.get(2).states()).containsExactly(2L);
    }

    @Test
    void furtherRunsAreAdded() {
        CoverageCount first = new CoverageCount(ITEMS);
        CoverageCount second = new CoverageCount(ITEMS);
        CoverageCount both = new CoverageCount(ITEMS);
        first.see(reached(0, 3, 6, 8));
        second.see(reached(0, 2, 3, 5, 10, 12));
        second.see(reached(4));
        for (int[] each : new int[][] {{0, 3, 6, 8}, {0, 2, 3, 5, 10, 12}, {4}}) {
            both.see(reached(each));
        }
        assertThat(first.coverage().and(second.coverage())).isEqualTo(both.coverage());
    }

    /** A run that has not begun in a state, and come to it by no transition, was not in it. */
    @Test
    void aRunThatEndedBeforeItBeganWasNowhere() {
        CoverageCount count = new CoverageCount(ITEMS);
        count.see(reached());
        assertThat(count.coverage().runs()).isEqualTo(1);
        assertThat(count.coverage().visited()).isZero();
        count.see(reached(4));
        assertThat(count.coverage().automata().get(0).states()).containsExactly(0L, 0L, 1L);
    }

    @Property
    void aSetIsTheSameAsText(@ForAll Set<@IntRange(max = 300) Integer> numbers) {
        BitSet all = new BitSet();
        numbers.forEach(all::set);
        ReachedItems reached = ReachedItems.of(all);
        assertThat(new ReachedItems(reached.text())).isEqualTo(reached);
        for (int number = 0; number <= 310; number++) {
            assertThat(reached.contains(number)).isEqualTo(numbers.contains(number));
        }
        assertThat(reached.countBelow(200))
                .isEqualTo((int) numbers.stream().filter(each -> each < 200).count());
    }

    @Test
    void digitsBeginWithTheFirstNumbers() {
        assertThat(reached().text()).isEqualTo("x");
        assertThat(reached(0).text()).isEqualTo("x1");
        assertThat(reached(3, 4, 9).text()).isEqualTo("x812");
    }

    @ParameterizedTest
    @ValueSource(strings = {"1", "x0", "x10", "xg", "xA", "x1 ", "y1"})
    void anythingElseIsNone(String text) {
        assertThatThrownBy(() -> new ReachedItems(text))
                .isInstanceOf(IllegalArgumentException.class);
    }
}
