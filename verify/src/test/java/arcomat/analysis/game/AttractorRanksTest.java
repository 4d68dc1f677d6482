package arcomat.analysis.game;

import static org.assertj.core.api.Assertions.assertThat;

import arcomat.analysis.game.Game.Demand;

import org.junit.jupiter.api.Test;

import java.util.List;

/** How many inputs it takes to win, and the first of the inputs that take as few. */
class AttractorRanksTest {
    private static final AttractorRanks RANKS =
            AttractorRanks.of(
                    List.of(
                            demand(5, 0, 4, 0),
                            demand(4, 2, 2, 3),
                            demand(4, 1, 3),
                            demand(3, 4, 2),
                            demand(2, 1),
                            demand(2, 0),
                            demand(2, 3, 0),
                            demand(1, 0, 1)),
                    6);

    private static Demand demand(int position, int letter, int... answers) {
        return new Demand(position, letter, answers);
    }

    @Test
    void ofPositions() {
        assertThat(RANKS.of(2)).isEqualTo(1);
        assertThat(RANKS.of(3)).isEqualTo(2);
        assertThat(RANKS.of(4)).isEqualTo(3);
        assertThat(RANKS.letter(2)).isZero();
        assertThat(RANKS.letter(3)).isEqualTo(4);
        assertThat(RANKS.letter(4)).isEqualTo(1);
    }

    @Test
    void whereTheSystemHasAnAnswerItIsNeverLost() {
        assertThat(RANKS.of(0)).isEqualTo(AttractorRanks.NEVER);
        assertThat(RANKS.of(1)).isEqualTo(AttractorRanks.NEVER);
        assertThat(RANKS.of(5)).isEqualTo(AttractorRanks.NEVER);
        assertThat(RANKS.of(6)).isEqualTo(AttractorRanks.NEVER);
    }

    @Test
    void theLongestOfSomeCounts() {
        assertThat(RANKS.of(new int[0])).isZero();
        assertThat(RANKS.of(new int[] {3, 2})).isEqualTo(2);
        assertThat(RANKS.of(new int[] {2, 5, 3})).isEqualTo(AttractorRanks.NEVER);
    }
}
