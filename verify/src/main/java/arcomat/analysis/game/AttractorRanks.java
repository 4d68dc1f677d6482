package arcomat.analysis.game;

import com.carrotsearch.hppc.IntArrayList;

import java.util.Arrays;
import java.util.List;

/**
 * How many inputs the environment needs to win from each position, whatever the system does, and
 * with which it begins: the layers of the attractor to the positions without an answer.
 */
final class AttractorRanks {
    /** The rank of a position that is not known to be lost. */
    static final int NEVER = Integer.MAX_VALUE;

    private final int[] ranks;
    private final int[] letters;

    private AttractorRanks(int positions) {
        ranks = new int[positions];
        letters = new int[positions];
        Arrays.fill(ranks, NEVER);
    }

    /** Counts round by round from the demands that nothing answers. */
    static AttractorRanks of(List<Game.Demand> demands, int positions) {
        AttractorRanks found = new AttractorRanks(positions);
        int[] open = new int[demands.size()];
        IntArrayList[] answered = new IntArrayList[positions];
        Arrays.setAll(answered, position -> new IntArrayList(2));
        IntArrayList level = new IntArrayList();
        for (int demand = 0; demand < open.length; demand++) {
            int[] answers = demands.get(demand).answers();
            open[demand] = answers.length;
            for (int answer : answers) {
                answered[answer].add(demand);
            }
            if (answers.length == 0) {
                level.add(demand);
            }
        }
        for (int rank = 1; !level.isEmpty(); rank++) {
            level = found.next(level, rank, demands, open, answered);
        }
        return found;
    }

    /**
     * @param level demands that cannot be met any more
     */
    private IntArrayList next(
            IntArrayList level,
            int rank,
            List<Game.Demand> demands,
            int[] open,
            IntArrayList[] answered) {
        IntArrayList fallen = new IntArrayList();
        for (int i = 0; i < level.size(); i++) {
            Game.Demand demand = demands.get(level.get(i));
            int position = demand.position();
            if (ranks[position] == NEVER) {
                ranks[position] = rank;
                letters[position] = demand.letter();
                fallen.add(position);
            } else if (ranks[position] == rank) {
                letters[position] = Math.min(letters[position], demand.letter());
            }
        }
        IntArrayList next = new IntArrayList();
        for (int i = 0; i < fallen.size(); i++) {
            IntArrayList lost = answered[fallen.get(i)];
            for (int j = 0; j < lost.size(); j++) {
                if (--open[lost.get(j)] == 0) {
                    next.add(lost.get(j));
                }
            }
        }
        return next;
    }

    /** How many inputs it takes. */
    int of(int position) {
        return position < ranks.length ? ranks[position] : NEVER;
    }

    /** The most inputs that it takes from one of some positions; 0 where there are none. */
    int of(int[] positions) {
        int most = 0;
        for (int position : positions) {
            most = Math.max(most, of(position));
        }
        return most;
    }

    /** The input to begin with; only where the environment wins. */
    int letter(int position) {
        return letters[position];
    }
}
