package arcomat.analysis.game;

import arcomat.analysis.Budget;

import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.BitSet;
import java.util.Comparator;
import java.util.Deque;
import java.util.HashMap;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;

/**
 * Minimal contradicting subsets of some requirements. Most contradictions are between two, and a
 * pair is a small game, so pairs are played first; then each group as a whole; and triples where
 * that is too large. A contradicting group is made minimal by QuickXplain (Junker 2004); all
 * minimal subsets are found with a hitting set tree (Reiter 1987).
 */
public final class Cores {
    /** A game of more positions is put off. */
    private static final long SMALL = 20_000;

    private final List<Requirement> requirements;
    private final Groups groups;
    private final Choices choices;
    private final Budget budget;
    private final Map<BitSet, Game.Winner> known = new HashMap<>();
    private final Map<BitSet, Game> won = new HashMap<>();
    private String stopped;
    private long explored;

    public Cores(List<Requirement> requirements, Groups groups, Choices choices, Budget budget) {
        this.requirements = requirements;
        this.groups = groups;
        this.choices = choices;
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
        List<BitSet> cores = new ArrayList<>();
        Set<BitSet> seen = new HashSet<>();
        Deque<BitSet> open = new ArrayDeque<>(List.of(new BitSet()));
        while (!open.isEmpty() && stopped == null) {
            BitSet removed = open.removeFirst();
            Optional<BitSet> core =
                    cores.stream().filter(each -> !each.intersects(removed)).findFirst();
            if (core.isEmpty()) {
                BitSet rest = all();
                rest.andNot(removed);
                core = in(rest);
                core.ifPresent(cores::add);
            }
            core.ifPresent(
                    each ->
                            each.stream()
                                    .mapToObj(member -> with(removed, member))
                                    .filter(seen::add)
                                    .forEach(open::addLast));
        }
        cores.sort(Comparator.comparingInt(BitSet::cardinality).thenComparing(BitSet::toString));
        return cores;
    }

    private static BitSet with(BitSet set, int member) {
        BitSet larger = (BitSet) set.clone();
        larger.set(member);
        return larger;
    }

    private Optional<BitSet> in(BitSet candidates) {
        for (BitSet group : groups.of(candidates)) {
            Optional<BitSet> pair = contradictingPair(group);
            if (pair.isPresent()) {
                return pair;
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

    private Optional<BitSet> inGroup(BitSet group) {
        Game.Winner winner = play(group, SMALL);
        if (winner == Game.Winner.UNKNOWN) {
            Optional<BitSet> triple = contradictingTriple(group);
            if (triple.isPresent()) {
                return triple;
            }
            winner = play(group, budget.states());
        }
        return winner == Game.Winner.ENVIRONMENT ? Optional.of(minimal(group)) : Optional.empty();
    }

    private Optional<BitSet> contradictingPair(BitSet group) {
        return group.stream()
                .boxed()
                .flatMap(
                        one ->
                                group.stream()
                                        .filter(other -> one < other)
                                        .filter(other -> groups.areNeighbours(one, other))
                                        .mapToObj(other -> with(with(new BitSet(), one), other)))
                .filter(pair -> play(pair, SMALL) == Game.Winner.ENVIRONMENT)
                .findFirst();
    }

    private Optional<BitSet> contradictingTriple(BitSet group) {
        List<Integer> members = group.stream().boxed().toList();
        for (int one : members) {
            for (int two : members) {
                for (int three : members) {
                    BitSet triple = with(with(with(new BitSet(), one), two), three);
                    if (one < two
                            && two < three
                            && groups.of(triple).size() == 1
                            && play(triple, SMALL) == Game.Winner.ENVIRONMENT) {
                        return Optional.of(triple);
                    }
                }
            }
        }
        return Optional.empty();
    }

    private BitSet minimal(BitSet contradicting) {
        return explain(new BitSet(), false, contradicting);
    }

    /** Which of the candidates are needed besides the background to make a contradiction. */
    private BitSet explain(BitSet background, boolean grown, BitSet candidates) {
        if (grown && contradicts(background)) {
            return new BitSet();
        }
        if (candidates.cardinality() == 1) {
            return candidates;
        }
        int[] members = candidates.stream().toArray();
        BitSet first = new BitSet();
        BitSet second = new BitSet();
        for (int i = 0; i < members.length; i++) {
            (i < members.length / 2 ? first : second).set(members[i]);
        }
        BitSet needed = explain(union(background, first), true, second);
        BitSet others = explain(union(background, needed), !needed.isEmpty(), first);
        return union(needed, others);
    }

    private static BitSet union(BitSet one, BitSet other) {
        BitSet union = (BitSet) one.clone();
        union.or(other);
        return union;
    }

    private boolean contradicts(BitSet subset) {
        for (BitSet group : groups.of(subset)) {
            if (play(group, budget.states()) == Game.Winner.ENVIRONMENT) {
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
                if (play(group, budget.states()) != Game.Winner.SYSTEM) {
                    return false;
                }
            }
        }
        return true;
    }

    /** One requirement alone never contradicts itself: every input has a reaction. */
    private Game.Winner play(BitSet group, long most) {
        if (group.cardinality() < 2) {
            return Game.Winner.SYSTEM;
        }
        Game.Winner winner = known.get(group);
        if (winner == null || winner == Game.Winner.UNKNOWN && most == budget.states()) {
            Game game = game(group, most);
            winner = game.play();
            explored += game.explored();
            known.put(group, winner);
            if (winner == Game.Winner.UNKNOWN && most == budget.states()) {
                stopped = game.stopped().orElseThrow();
            }
            if (winner == Game.Winner.SYSTEM && groups.of(all()).contains(group)) {
                won.put(group, game);
            }
        }
        return winner;
    }

    private Game game(BitSet group, long most) {
        List<Requirement> members = group.stream().mapToObj(requirements::get).toList();
        Budget own = new Budget(budget.timeIsUp(), Math.min(most, budget.states()));
        return new Game(new Rules(members, choices), own);
    }

    /** The game of a contradicting subset, to be told. */
    public Game lost(BitSet core) {
        Game game = game(core, budget.states());
        game.play();
        return game;
    }

    /** The games of all groups, each won by the system, unless some were stopped. */
    public List<Game> won() {
        List<Game> games = new ArrayList<>();
        for (BitSet group : groups.of(all())) {
            Game game = won.get(group);
            if (game == null) {
                game = game(group, budget.states());
                if (game.play() != Game.Winner.SYSTEM) {
                    stopped = game.stopped().orElseThrow();
                }
            }
            games.add(game);
        }
        return games;
    }
}
