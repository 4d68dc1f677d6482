package arcomat.analysis.game;

import arcomat.analysis.Budget;
import arcomat.analysis.engine.Alphabet;

import com.carrotsearch.hppc.IntArrayList;

import java.util.ArrayList;
import java.util.BitSet;
import java.util.List;
import java.util.Optional;

/**
 * Who wins: a safety game that the system loses where no output complies. Positions are explored
 * breadth first, and what is lost is carried back at once, so that a short way to win is found
 * before the rest is explored.
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
    private record Demand(int position, int letter, int[] answers) {}

    private final Rules rules;
    private final Budget budget;
    private final BitSet lost = new BitSet();
    private final List<Demand> demands = new ArrayList<>();
    private final IntArrayList alive = new IntArrayList();

    /** Per position the demands that it answers. */
    private final List<IntArrayList> answered = new ArrayList<>();

    private final IntArrayList fallen = new IntArrayList();
    private int explored = Rules.FREE + 1;
    private String stopped;

    public Game(Rules rules, Budget budget) {
        this.rules = rules;
        this.budget = budget;
    }

    Rules rules() {
        return rules;
    }

    /** Explores until the winner is known. */
    public Winner play() {
        return explore(true);
    }

    /** Explores all positions, also where the winner is known. */
    Winner playOn() {
        return explore(false);
    }

    private Winner explore(boolean untilKnown) {
        while (!(untilKnown && isLost()) && explored < rules.size()) {
            stopped = budget.exhausted(explored);
            if (stopped != null) {
                return isLost() ? Winner.ENVIRONMENT : Winner.UNKNOWN;
            }
            expand(explored++);
            carryBack();
        }
        return isLost() ? Winner.ENVIRONMENT : Winner.SYSTEM;
    }

    /** Why the search was stopped. */
    public Optional<String> stopped() {
        return Optional.ofNullable(stopped);
    }

    /** How many positions were explored. */
    public int explored() {
        return explored;
    }

    /** Whether each beginning is lost. */
    private boolean isLost() {
        for (Rules.Option option : rules.openings()) {
            if (!lost.get(option.position())) {
                return false;
            }
        }
        return true;
    }

    /** Whether it is known that the environment wins from here. */
    boolean isLost(int position) {
        return lost.get(position);
    }

    /** Whether it is known that the system wins from here. */
    boolean isWon(int position) {
        return position == Rules.FREE || explored == rules.size() && !lost.get(position);
    }

    private void expand(int position) {
        Alphabet alphabet = rules.alphabet(position);
        for (int letter = 0; letter < alphabet.size(); letter++) {
            List<Rules.Option> options = rules.options(position, alphabet.letter(letter));
            IntArrayList answers = new IntArrayList(options.size());
            boolean settled = false;
            for (Rules.Option option : options) {
                settled |= option.position() == Rules.FREE;
                if (!answers.contains(option.position())) {
                    answers.add(option.position());
                }
            }
            if (!settled) {
                demand(position, letter, answers.toArray());
            }
        }
    }

    private void demand(int position, int letter, int[] answers) {
        int demand = demands.size();
        demands.add(new Demand(position, letter, answers));
        int count = 0;
        for (int answer : answers) {
            if (!lost.get(answer)) {
                count++;
                while (answered.size() <= answer) {
                    answered.add(null);
                }
                if (answered.get(answer) == null) {
                    answered.set(answer, new IntArrayList(2));
                }
                answered.get(answer).add(demand);
            }
        }
        alive.add(count);
        if (count == 0) {
            lose(position);
        }
    }

    private void lose(int position) {
        if (!lost.get(position)) {
            lost.set(position);
            fallen.add(position);
        }
    }

    private void carryBack() {
        while (!fallen.isEmpty()) {
            int position = fallen.removeLast();
            IntArrayList open = position < answered.size() ? answered.get(position) : null;
            for (int i = 0; open != null && i < open.size(); i++) {
                int demand = open.get(i);
                alive.set(demand, alive.get(demand) - 1);
                if (alive.get(demand) == 0) {
                    lose(demands.get(demand).position());
                }
            }
        }
    }

    /**
     * For each lost position the letter with which the environment wins soonest, whatever the
     * system does; -1 elsewhere. Positions are ranked by the number of inputs that it takes.
     */
    int[] winningLetters() {
        int[] letters = new int[rules.size()];
        java.util.Arrays.fill(letters, -1);
        BitSet ranked = new BitSet();
        boolean more = true;
        while (more) {
            BitSet next = new BitSet();
            for (Demand demand : demands) {
                if (!ranked.get(demand.position())
                        && !next.get(demand.position())
                        && allIn(ranked, demand.answers())) {
                    next.set(demand.position());
                    letters[demand.position()] = demand.letter();
                }
            }
            ranked.or(next);
            more = !next.isEmpty();
        }
        return letters;
    }

    private static boolean allIn(BitSet ranked, int[] positions) {
        for (int position : positions) {
            if (!ranked.get(position)) {
                return false;
            }
        }
        return true;
    }
}
