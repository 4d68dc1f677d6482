package arcomat.laws.naive;

import arcomat.laws.naive.NaiveBehaviour.Move;
import arcomat.laws.naive.NaiveBehaviour.Moves;
import arcomat.laws.naive.NaiveBehaviour.State;
import arcomat.model.Port;
import arcomat.model.Value;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.HashSet;
import java.util.IdentityHashMap;
import java.util.List;
import java.util.Map;
import java.util.OptionalInt;
import java.util.Set;

/** Whether all that one side shows is shown by the other one, slice by slice, by trying all. */
final class NaiveComparison {
    /**
     * A run of the left side, by where it is, with all runs of the right side that look the same.
     */
    private record Pair(State left, Set<State> right) {}

    /** Moves of both sides that are put beside each other. */
    private static final long MOST_WORK = 20_000;

    /** There is too much to write out. */
    static final class TooMuch extends RuntimeException {
        private static final long serialVersionUID = 1L;
    }

    private long work;
    private final NaiveBehaviour left;
    private final NaiveBehaviour right;
    private final List<Map<String, Value>> letters;
    private final int mostPairs;
    private final Set<Pair> seen = new HashSet<>();
    private final Map<State, Map<Map<String, Value>, Moves>> mineKnown = new HashMap<>();
    private final Map<State, Map<Map<String, Value>, Moves>> theirsKnown = new HashMap<>();

    /**
     * @param left writes its outputs out
     * @param letters inputs that are tried
     */
    public NaiveComparison(
            NaiveBehaviour left,
            NaiveBehaviour right,
            List<Map<String, Value>> letters,
            int mostPairs) {
        this.left = left;
        this.right = right;
        this.letters = letters;
        this.mostPairs = mostPairs;
    }

    /** Whether the left side fits into every feedback that the right one fits into. */
    public boolean fitsFeedback() {
        for (Port input : right.component().inputs()) {
            for (Port output : right.component().outputs()) {
                boolean mine = left.isAtOnce(input.name(), output.name());
                if (mine && !right.isAtOnce(input.name(), output.name())) {
                    return false;
                }
            }
        }
        return true;
    }

    /**
     * The number of inputs after which the left side first shows what the right one does not.
     *
     * @return empty if there is none among the pairs that are looked at
     */
    public OptionalInt shortestFailure(int mostInputs) {
        List<Pair> level = new ArrayList<>();
        Moves mine = left.starts();
        Moves theirs = right.starts();
        if (mine.error() && !theirs.error()) {
            return OptionalInt.of(0);
        }
        for (Move start : mine.moves()) {
            Set<State> same = agreeing(theirs.moves(), start);
            if (same.isEmpty()) {
                return OptionalInt.of(0);
            }
            add(new Pair(start.next(), same), level);
        }
        for (int inputs = 1; inputs <= mostInputs && !level.isEmpty(); inputs++) {
            List<Pair> next = new ArrayList<>();
            for (Pair pair : level) {
                for (Map<String, Value> letter : letters) {
                    if (fails(pair, letter, next)) {
                        return OptionalInt.of(inputs);
                    }
                }
            }
            level = next;
        }
        return OptionalInt.empty();
    }

    /** Whether no pair was left out because there are too many. */
    boolean isExhaustive() {
        return seen.size() < mostPairs;
    }

    private void add(Pair pair, List<Pair> level) {
        if (seen.size() < mostPairs && seen.add(pair)) {
            level.add(pair);
        }
    }

    private boolean fails(Pair pair, Map<String, Value> letter, List<Pair> next) {
        Moves mine = moves(left, mineKnown, pair.left, letter);
        boolean mayErr = false;
        Set<Waiting> theirs = new HashSet<>();
        for (State state : pair.right) {
            Moves own = moves(right, theirsKnown, state, letter);
            mayErr |= own.error() && showsNoMore(state);
            own.moves().forEach(move -> theirs.add(new Waiting(state, move)));
        }
        work += (long) theirs.size() * mine.moves().size();
        if (work > MOST_WORK) {
            throw new TooMuch();
        }
        if (mine.error() && !(mayErr && othersShow(pair.left))) {
            return true;
        }
        for (Move move : mine.moves()) {
            Set<Move> same = new HashSet<>();
            for (Waiting each : theirs) {
                if (nowAgrees(pair.left, move, each)) {
                    same.add(each.move);
                }
            }
            Set<State> after = agreeing(same, move.next());
            if (after.isEmpty()) {
                return true;
            }
            add(new Pair(move.next(), after), next);
        }
        return false;
    }

    private static Moves moves(
            NaiveBehaviour side,
            Map<State, Map<Map<String, Value>, Moves>> known,
            State before,
            Map<String, Value> letter) {
        return known.computeIfAbsent(before, each -> new IdentityHashMap<>())
                .computeIfAbsent(letter, each -> side.moves(before, letter));
    }

    /** A move of the right side, and where it comes from. */
    private record Waiting(State before, Move move) {}

    /** In the slice of an error, the left side shows each message that the right one does. */
    private boolean showsNoMore(State theirs) {
        return right.component().outputs().stream()
                .map(Port::name)
                .filter(name -> right.isLate(name) && !mayBeLate(left, name))
                .allMatch(name -> right.due(theirs, name).allows(Slot.SILENCE.messages()));
    }

    /** In the slice of an error, the right side shows each message that the left one does. */
    private boolean othersShow(State mine) {
        return right.component().outputs().stream()
                .map(Port::name)
                .filter(name -> left.isLate(name) && !mayBeLate(right, name))
                .allMatch(name -> left.due(mine, name).equals(Slot.SILENCE));
    }

    /** Silence has no delay of its own. */
    private static boolean mayBeLate(NaiveBehaviour side, String output) {
        return side.isLate(output) || !side.isConnected(output);
    }

    private boolean nowAgrees(State before, Move mine, Waiting theirs) {
        for (Port port : right.component().outputs()) {
            String name = port.name();
            Slot shown = left.isLate(name) ? left.due(before, name) : mine.outputs().get(name);
            Slot allowed =
                    right.isLate(name)
                            ? right.due(theirs.before, name)
                            : theirs.move.outputs().get(name);
            if (!allowed.allows(shown.messages())) {
                return false;
            }
        }
        return true;
    }

    private Set<State> agreeing(Set<Move> moves, State mine) {
        Set<State> found = new HashSet<>();
        for (Move move : moves) {
            boolean same =
                    right.component().outputs().stream()
                            .map(Port::name)
                            .filter(name -> mayBeLate(left, name) && mayBeLate(right, name))
                            .allMatch(
                                    name ->
                                            right.due(move.next(), name)
                                                    .allows(left.due(mine, name).messages()));
            if (same) {
                found.add(move.next());
            }
        }
        return found;
    }

    private Set<State> agreeing(Set<Move> starts, Move mine) {
        Set<Move> same = new HashSet<>();
        for (Move start : starts) {
            boolean agrees =
                    start.outputs().entrySet().stream()
                            .allMatch(
                                    e ->
                                            e.getValue()
                                                    .allows(
                                                            mine.outputs()
                                                                    .get(e.getKey())
                                                                    .messages()));
            if (agrees) {
                same.add(start);
            }
        }
        return agreeing(same, mine.next());
    }
}
