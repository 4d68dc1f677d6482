package arcomat.analysis.game;

import arcomat.analysis.search.Budget;

import org.jspecify.annotations.Nullable;

import java.util.ArrayList;
import java.util.BitSet;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.stream.IntStream;
import java.util.stream.Stream;

/**
 * Minimal contradicting subsets of some requirements. Most contradictions are between two, and a
 * pair is a small game, so pairs are played first; then each group as a whole; and where that is
 * too large, those few that may contradict each other. What needs no game because all that is ever
 * asked for can be answered together is not played at all.
 */
public final class UnsatCores {
    /** A game of more moves is put off. */
    private static final long SMALL = 100_000;

    private static final long LARGE = 5_000_000;
    private static final long ALL = Long.MAX_VALUE;

    private static final int MOST_SUSPECTS = 1_000;

    private final List<Requirement> requirements;
    private final Groups groups;
    private final Choices choices;
    private final Projections projections;
    private final Budget budget;
    private final Map<BitSet, Game.Winner> known = new HashMap<>();
    private final Map<BitSet, Long> tried = new HashMap<>();
    private final Map<BitSet, Game> won = new HashMap<>();
    private final Map<BitSet, Game> lost = new HashMap<>();
    private @Nullable String stopped;
    private long explored;

    public UnsatCores(
            List<Requirement> requirements, Groups groups, Choices choices, Budget budget) {
        this.requirements = requirements;
        this.groups = groups;
        this.choices = choices;
        this.projections = new Projections(requirements, choices);
        this.budget = budget;
    }

    /** Why some games could not be decided; empty where all could. */
    public Optional<String> stopped() {
        return Optional.ofNullable(stopped);
    }

    /** Positions of all games so far. */
    public long explored() {
        return explored;
    }

    private BitSet all() {
        BitSet all = new BitSet();
        all.set(0, requirements.size());
        return all;
    }

    /** A minimal contradicting subset of all requirements; empty where none was found. */
    public Optional<BitSet> first() {
        return in(all());
    }

    /** All minimal contradicting subsets that were found, small ones first. */
    public List<BitSet> every() {
        return MinimalSets.all(all(), this::in, () -> stopped != null);
    }

    private Optional<BitSet> in(BitSet candidates) {
        Optional<BitSet> alone = contradicting(singles(candidates), SMALL);
        if (alone.isPresent()) {
            return alone;
        }
        for (BitSet group : groups.of(candidates)) {
            Optional<BitSet> pair = contradicting(pairs(group), SMALL);
            if (pair.isPresent()) {
                return pair.map(set -> MinimalSets.of(set, this::contradicts));
            }
        }
        for (BitSet group : groups.of(candidates)) {
            Optional<BitSet> core = inGroup(group);
            if (core.isPresent()) {
                return core;
            }
        }
        return Optional.empty();
    }

    private static Stream<BitSet> singles(BitSet group) {
        return group.stream().mapToObj(UnsatCores::set);
    }

    private Stream<BitSet> pairs(BitSet group) {
        List<BitSet> pairs = new ArrayList<>();
        for (int one = group.nextSetBit(0); one >= 0; one = group.nextSetBit(one + 1)) {
            for (int other = group.nextSetBit(one + 1);
                    other >= 0;
                    other = group.nextSetBit(other + 1)) {
                if (groups.areNeighbours(one, other)) {
                    pairs.add(set(one, other));
                }
            }
        }
        return pairs.stream();
    }

    private static BitSet set(int... members) {
        BitSet set = new BitSet();
        IntStream.of(members).forEach(set::set);
        return set;
    }

    private Optional<BitSet> inGroup(BitSet group) {
        Game.Winner winner = play(group, SMALL);
        if (winner == Game.Winner.UNKNOWN) {
            List<BitSet> suspects = suspects(group);
            for (long moves : new long[] {SMALL, LARGE}) {
                Optional<BitSet> found = contradicting(suspects.stream(), moves);
                if (found.isPresent()) {
                    return found.map(set -> MinimalSets.of(set, this::contradicts));
                }
            }
            winner = play(group, ALL);
        }
        return winner == Game.Winner.ENVIRONMENT
                ? Optional.of(MinimalSets.of(group, this::contradicts))
                : Optional.empty();
    }

    /** Small sets that may contradict each other, as far as each of them alone can tell. */
    private List<BitSet> suspects(BitSet group) {
        long[] looks = {0};
        return MinimalSets.all(
                group,
                rest ->
                        projections.mayContradict(rest)
                                ? Optional.of(MinimalSets.of(rest, projections::mayContradict))
                                : Optional.empty(),
                () -> looks[0]++ > MOST_SUSPECTS);
    }

    private Optional<BitSet> contradicting(Stream<BitSet> sets, long moves) {
        return sets.filter(set -> play(set, moves) == Game.Winner.ENVIRONMENT).findFirst();
    }

    private boolean contradicts(BitSet subset) {
        for (BitSet group : groups.of(subset)) {
            if (play(group, ALL) == Game.Winner.ENVIRONMENT) {
                return true;
            }
        }
        return false;
    }

    /** Whether no requirement of a contradicting subset can be left out; false also if unknown. */
    public boolean isMinimal(BitSet core) {
        for (int member : core.stream().toArray()) {
            BitSet rest = (BitSet) core.clone();
            rest.clear(member);
            for (BitSet group : groups.of(rest)) {
                if (play(group, ALL) != Game.Winner.SYSTEM) {
                    return false;
                }
            }
        }
        return true;
    }

    /** One requirement alone never contradicts itself, unless it may not react to an input. */
    private Game.Winner play(BitSet group, long most) {
        boolean alone = group.cardinality() < 2;
        if (alone && group.stream().noneMatch(each -> requirements.get(each).mayFail())) {
            return Game.Winner.SYSTEM;
        }
        Game.Winner winner = known.get(group);
        if (winner == null && !projections.mayContradict(group)) {
            winner = Game.Winner.SYSTEM;
            known.put(group, winner);
        }
        if (winner == null
                || winner == Game.Winner.UNKNOWN && most > tried.getOrDefault(group, 0L)) {
            tried.put(group, most);
            Game game = game(group, most);
            winner = game.play();
            explored += game.explored();
            known.put(group, winner);
            if (winner == Game.Winner.UNKNOWN && most == ALL) {
                stopped = game.stopped().orElseThrow();
            }
            if (winner == Game.Winner.ENVIRONMENT && most == SMALL) {
                lost.put(group, game);
            }
            if (winner == Game.Winner.SYSTEM && groups.of(all()).contains(group)) {
                won.put(group, game);
            }
        }
        return winner;
    }

    private Game game(BitSet group, long moves) {
        List<Requirement> members = group.stream().mapToObj(requirements::get).toList();
        return new Game(new Arena(members, choices, budget), budget, moves);
    }

    /** The game of a contradicting subset, to be told. */
    public Game lost(BitSet core) {
        Game game = lost.get(core);
        if (game == null) {
            game = game(core, ALL);
            game.play();
        }
        return game;
    }

    /**
     * The games of all groups, which the system wins. Those that need no search are only played to
     * tell where errors can be avoided.
     */
    public List<Game> won() {
        List<Game> games = new ArrayList<>();
        for (BitSet group : groups.of(all())) {
            Game game = won.get(group);
            if (game == null) {
                game = game(group, SMALL);
                if (group.stream().allMatch(each -> requirements.get(each).mayEnd())) {
                    game.play();
                }
            }
            games.add(game);
        }
        return games;
    }
}
