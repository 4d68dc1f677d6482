package arcomat.analysis.game;

import arcomat.analysis.game.Requirement.Reply;
import arcomat.analysis.search.letter.Alphabet;
import arcomat.analysis.search.step.OutputCubes;
import arcomat.model.Value;

import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.BitSet;
import java.util.Deque;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Optional;
import java.util.Set;

/**
 * A look at each requirement alone, before any game: which outputs it ever asks for, wherever it
 * may be. If whatever some requirements may ask for can be answered together, they do not
 * contradict each other, and their product need not be explored.
 */
final class Projections {
    private static final int MOST_CONFIGURATIONS = 10_000;
    private static final int MOST_COMBINATIONS = 10_000;

    private final List<Requirement> requirements;
    private final Choices choices;
    private final List<Optional<int[]>> asked = new ArrayList<>();
    private int combinations;

    Projections(List<Requirement> requirements, Choices choices) {
        this.requirements = requirements;
        this.choices = choices;
        requirements.forEach(each -> asked.add(null));
    }

    /** False where it is certain that the system can always answer. */
    boolean mayContradict(BitSet group) {
        int[] members = group.stream().toArray();
        int[] openings = new int[members.length];
        for (int i = 0; i < members.length; i++) {
            openings[i] = requirements.get(members[i]).opening().list();
        }
        if (choices.of(openings).isEmpty()) {
            return true;
        }
        combinations = 0;
        return mayContradict(members, new int[0]);
    }

    private boolean mayContradict(int[] members, int[] chosen) {
        if (combinations++ > MOST_COMBINATIONS || !canAnswer(chosen)) {
            return true;
        }
        if (chosen.length == members.length) {
            return false;
        }
        Optional<int[]> lists = asked(members[chosen.length]);
        if (lists.isEmpty()) {
            return true;
        }
        int[] longer = Arrays.copyOf(chosen, chosen.length + 1);
        for (int list : lists.get()) {
            longer[chosen.length] = list;
            if (mayContradict(members, longer.clone())) {
                return true;
            }
        }
        return false;
    }

    /**
     * With an output, or with an error. Chaos forbids errors, but is not asked: it is only reached
     * by a step that forbids them, too.
     */
    private boolean canAnswer(int[] chosen) {
        return !choices.of(chosen).isEmpty() || choices.mayEnd(chosen);
    }

    /**
     * Numbers of the lists of cubes of all single configurations, without those that ask for less
     * than another; empty if there are too many.
     */
    private Optional<int[]> asked(int number) {
        if (asked.get(number) == null) {
            asked.set(number, explore(requirements.get(number)).map(this::strongest));
        }
        return asked.get(number);
    }

    private int[] strongest(Set<Integer> lists) {
        List<Integer> strongest = new ArrayList<>();
        for (int list : lists) {
            if (strongest.stream().noneMatch(other -> choices.isWeaker(list, other))) {
                strongest.removeIf(other -> choices.isWeaker(other, list));
                strongest.add(list);
            }
        }
        return strongest.stream().mapToInt(Integer::intValue).toArray();
    }

    private Optional<Set<Integer>> explore(Requirement requirement) {
        Set<Integer> lists = new LinkedHashSet<>();
        Set<Integer> met = new LinkedHashSet<>();
        Deque<Integer> open = new ArrayDeque<>();
        add(requirement, requirement.opening(), met, open);
        while (!open.isEmpty()) {
            if (met.size() > MOST_CONFIGURATIONS) {
                return Optional.empty();
            }
            int set = open.removeFirst();
            Alphabet alphabet = requirement.alphabet(set);
            for (int letter = 0; letter < alphabet.size(); letter++) {
                Value[] messages = alphabet.letter(letter);
                Reply reply = requirement.reply(set, messages);
                lists.add(reply.list());
                add(requirement, reply, met, open);
            }
        }
        return Optional.of(lists);
    }

    /** What lies behind each step alone; nothing is asked for in chaos or after the run's end. */
    private static void add(
            Requirement requirement, Reply reply, Set<Integer> met, Deque<Integer> open) {
        for (int cube = 0; cube < reply.cubes().length; cube++) {
            for (int next : reply.next()[cube]) {
                int set = requirement.alone(next);
                if (reply.cubes()[cube] != OutputCubes.ERROR
                        && set != Requirement.CHAOS
                        && met.add(set)) {
                    open.addLast(set);
                }
            }
        }
    }
}
