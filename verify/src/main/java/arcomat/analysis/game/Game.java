package arcomat.analysis.game;

import arcomat.analysis.search.Attractor;
import arcomat.analysis.search.Budget;
import arcomat.analysis.search.letter.Alphabet;
import arcomat.semantics.value.GivenUp;

import com.carrotsearch.hppc.IntArrayList;

import org.jspecify.annotations.Nullable;

import java.util.ArrayList;
import java.util.BitSet;
import java.util.List;
import java.util.Optional;

/**
 * Who wins: a safety game that the system loses where no output complies. Positions are explored
 * breadth first, and what is lost is carried back at once, so that a short way to win is found
 * before the rest is explored (on the fly: Cassez, David, Fleury, Larsen, Lime, "Efficient
 * on-the-fly algorithms for the analysis of timed games", CONCUR 2005).
 */
public final class Game {
    /** How a game ends. */
    public enum Winner {
        SYSTEM,
        ENVIRONMENT,
        /** The search was stopped. */
        UNKNOWN
    }

    /** Inputs of a position that the system has to answer. */
    record Demand(int position, int letter, int[] answers) {}

    /** More inputs are not tried in one position. */
    private static final int MOST_LETTERS = 200_000;

    private final Arena arena;
    private final Budget budget;
    private final long mostMoves;
    private long moves;
    private final Attractor lost = new Attractor();
    private final List<Demand> demands = new ArrayList<>();

    /** What was lost before errors were asked for; null until then. */
    private @Nullable BitSet lostUnerring;

    private final IntArrayList levels = new IntArrayList();
    private int explored = Arena.END + 1;
    private @Nullable String stopped;

    /**
     * @param mostMoves after so many inputs in all positions the search is stopped
     */
    public Game(Arena arena, Budget budget, long mostMoves) {
        this.arena = arena;
        this.budget = budget;
        this.mostMoves = mostMoves;
    }

    Arena arena() {
        return arena;
    }

    /** Explores until the winner is known. */
    public Winner play() {
        return explore(true, Integer.MAX_VALUE);
    }

    /**
     * Explores further where the winner is known.
     *
     * @param inputs leaves out positions that are only reached with as many inputs
     */
    void playOn(int inputs) {
        explore(false, inputs);
    }

    private Winner explore(boolean untilKnown, int inputs) {
        try {
            while (!(untilKnown && isLost())
                    && explored < arena.size()
                    && level(explored) < inputs) {
                stopped = exhausted();
                if (stopped != null) {
                    break;
                }
                expand(explored++);
                lost.propagate();
            }
            return isLost() ? Winner.ENVIRONMENT : stopped == null ? Winner.SYSTEM : Winner.UNKNOWN;
        } catch (GivenUp inTheMiddle) {
            stopped = String.valueOf(inTheMiddle.getMessage());
            return Winner.UNKNOWN;
        }
    }

    /** Why not to go on; counts the inputs of the next position. */
    private @Nullable String exhausted() {
        long letters = arena.letters(explored);
        moves += letters;
        if (letters > MOST_LETTERS || moves > mostMoves) {
            return "more than %d inputs to try at once"
                    .formatted(Math.min(MOST_LETTERS, mostMoves));
        }
        return budget.exhausted(explored());
    }

    /** With how many inputs a position is first reached. */
    private int level(int position) {
        while (levels.size() <= position) {
            levels.add(0);
        }
        return levels.get(position);
    }

    /** Why the search was stopped. */
    public Optional<String> stopped() {
        return Optional.ofNullable(stopped);
    }

    /** How many positions were explored; that the run has ended is none. */
    public int explored() {
        return explored - Arena.END;
    }

    /** Whether each beginning is lost. */
    private boolean isLost() {
        for (Arena.Option option : arena.openings()) {
            if (!isLost(option.position())) {
                return false;
            }
        }
        return true;
    }

    /** Whether it is known that the environment wins from here. */
    boolean isLost(int position) {
        return lostUnerring == null ? lost.isFallen(position) : lostUnerring.get(position);
    }

    /** Whether it is known that the system wins from here. */
    boolean isWon(int position) {
        return position == Arena.FREE
                || position == Arena.END
                || stopped == null && explored == arena.size() && !isLost(position);
    }

    /**
     * Whether it is known that every system errs or loses from here, or has done so. Once that was
     * asked, the game is not played on.
     */
    boolean errs(int position) {
        if (lostUnerring == null) {
            lostUnerring = lost.fallen();
            lost.fall(Arena.END);
            lost.propagate();
        }
        return lost.isFallen(position);
    }

    private void expand(int position) {
        int next = level(position) + 1;
        Alphabet alphabet = arena.alphabet(position);
        for (int letter : arena.different(alphabet, position)) {
            List<Arena.Option> options = arena.options(position, alphabet.letter(letter));
            IntArrayList answers = new IntArrayList(options.size());
            boolean settled = false;
            for (Arena.Option option : options) {
                settled |= option.position() == Arena.FREE;
                if (!answers.contains(option.position())) {
                    answers.add(option.position());
                }
            }
            if (!settled) {
                demands.add(new Demand(position, letter, answers.toArray()));
                lost.demand(position, answers.toArray());
            }
        }
        while (levels.size() < arena.size()) {
            levels.add(next);
        }
    }

    /** How soon the environment wins where it does. */
    AttractorRanks ranks() {
        return AttractorRanks.of(demands, arena.size());
    }
}
