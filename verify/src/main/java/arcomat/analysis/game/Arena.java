package arcomat.analysis.game;

import arcomat.analysis.game.Requirement.Reply;
import arcomat.analysis.search.Budget;
import arcomat.analysis.search.IntKey;
import arcomat.analysis.search.Numbering;
import arcomat.analysis.search.letter.Alphabet;
import arcomat.analysis.search.letter.LatchedPorts;
import arcomat.analysis.search.letter.LetterClasses;
import arcomat.model.Component;
import arcomat.model.Port;
import arcomat.model.Value;
import arcomat.semantics.expression.Output;
import arcomat.semantics.value.GivenUp;
import arcomat.semantics.value.InputAbstraction;
import arcomat.semantics.value.InputAbstraction.PortAbstraction;
import arcomat.semantics.value.MessageClasses;

import org.jspecify.annotations.Nullable;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.HashMap;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.stream.IntStream;

/**
 * The moves of the game: the environment picks an input letter, the system an output that none of
 * the requirements forbids. Outputs are chosen knowing the input that they react to, also where
 * they are seen one slice later.
 */
public final class Arena {
    /** The position in which no requirement asks for anything any more. */
    static final int FREE = 0;

    /** The position in which the run has ended in an error that all requirements allow. */
    static final int END = 1;

    /** Larger alphabets are not kept. */
    private static final int WORTH_MAKING_AGAIN = 10_000;

    /**
     * A move of the system.
     *
     * @param sent null where the run ends
     */
    record Option(@Nullable Output sent, int position) {
        private static final Option ERROR = new Option(null, END);
    }

    private final List<Requirement> requirements;
    private final Choices choices;
    private final Budget budget;
    private final Component.Profile profile;
    private final List<Port> inputs;
    private final int[] identity;
    private final LatchedPorts latched;

    /** It always matters whether latched ports hold something. */
    private final LetterClasses latchedClasses;

    private @Nullable List<Option> openings;
    private final Numbering<IntKey> positions = new Numbering<>();
    private final Map<List<Integer>, Alphabet> alphabets = new HashMap<>();

    /**
     * @param requirements at least one, all of the same component
     * @param budget of time and memory
     */
    public Arena(List<Requirement> requirements, Choices choices, Budget budget) {
        this.budget = budget;
        this.requirements = List.copyOf(requirements);
        this.choices = choices;
        this.profile = requirements.get(0).system().profile();
        this.inputs = requirements.get(0).system().inputs();
        this.identity = IntStream.range(0, inputs.size()).toArray();
        this.latched = LatchedPorts.of(profile, inputs);
        if (latched.positions().size() > Integer.SIZE) {
            throw new GivenUp("more than " + Integer.SIZE + " latched ports");
        }
        this.latchedClasses = new LetterClasses(0, latched.abstraction(inputs.size()), inputs);
        int[] free = new int[requirements.size() + 1];
        Arrays.fill(free, Requirement.CHAOS);
        positions.number(new IntKey(free));
        positions.number(new IntKey(new int[0]));
    }

    List<Requirement> requirements() {
        return requirements;
    }

    List<Port> inputs() {
        return inputs;
    }

    List<Port> outputs() {
        return choices.ports();
    }

    /** How many positions have been met. */
    int size() {
        return positions.size();
    }

    /** The sets that the requirements are in, one per requirement; behind them what is held. */
    private int[] sets(int position) {
        return positions.get(position).all();
    }

    private int held(int position) {
        return sets(position)[requirements.size()];
    }

    private int held(Value[] letter) {
        return (int) latched.held(letter);
    }

    /** How many letters matter in a position. */
    long letters(int position) {
        List<PortAbstraction> looks = abstraction(position).looks();
        boolean events = profile == Component.Profile.EVENT_DRIVEN;
        long together = 1;
        long alone = 0;
        for (int port = 0; port < looks.size() && together < Integer.MAX_VALUE; port++) {
            Port input = inputs.get(port);
            int samples = MessageClasses.of(input, input.total(), looks.get(port)).samples().size();
            if (events && !input.latched()) {
                alone += samples;
            } else {
                together *= samples;
            }
        }
        return events ? together * alone : together;
    }

    /** The letters that matter in some positions. */
    Alphabet alphabet(int... some) {
        List<LetterClasses> classes = new ArrayList<>();
        List<Integer> key = new ArrayList<>();
        for (int position : some) {
            int[] sets = sets(position);
            for (int i = 0; i < requirements.size(); i++) {
                if (sets[i] != Requirement.CHAOS) {
                    LetterClasses own = requirements.get(i).letterClasses(sets[i]);
                    classes.add(own);
                    key.add(i);
                    key.add(own.number());
                }
            }
        }
        Alphabet known = alphabets.get(key);
        if (known == null) {
            classes.add(latchedClasses);
            List<int[]> places = java.util.Collections.nCopies(classes.size(), identity);
            known = new Alphabet(profile, inputs, classes, places);
            if (known.size() < WORTH_MAKING_AGAIN) {
                alphabets.put(key, known);
            }
        }
        return known;
    }

    /** The states of the requirements in a position, as far as there are names for them. */
    List<String> states(int position) {
        List<String> names = new ArrayList<>();
        int[] sets = sets(position);
        for (int i = 0; i < requirements.size(); i++) {
            requirements.get(i).state(sets[i]).ifPresent(names::add);
        }
        return names;
    }

    /**
     * Of letters with the same consequences the first one, by its place in the alphabet.
     *
     * @param some positions after the same inputs
     */
    int[] different(Alphabet alphabet, int... some) {
        Set<List<Integer>> met = new HashSet<>();
        int[] different = new int[alphabet.size()];
        int count = 0;
        long before = Integer.toUnsignedLong(held(some[0]));
        for (int letter = 0; letter < alphabet.size(); letter++) {
            if (!latched.isPossible(before, alphabet.letter(letter))) {
                continue;
            }
            List<Integer> consequences = new ArrayList<>(some.length * requirements.size() + 1);
            consequences.add(held(alphabet.letter(letter)));
            for (int position : some) {
                for (Reply reply : replies(position, alphabet.letter(letter))) {
                    consequences.add(reply == null ? -1 : reply.number());
                }
            }
            if (met.add(consequences)) {
                different[count++] = letter;
            }
        }
        return Arrays.copyOf(different, count);
    }

    /** What matters in a position. */
    InputAbstraction abstraction(int position) {
        int[] sets = sets(position);
        InputAbstraction all = latchedClasses.abstraction();
        for (int i = 0; i < requirements.size(); i++) {
            if (sets[i] != Requirement.CHAOS) {
                all = all.and(requirements.get(i).letterClasses(sets[i]).abstraction());
            }
        }
        return all;
    }

    /** The system's first moves. */
    List<Option> openings() {
        if (openings == null) {
            openings = opening();
        }
        return openings;
    }

    private List<Option> opening() {
        Reply[] replies = new Reply[requirements.size()];
        for (int i = 0; i < replies.length; i++) {
            replies[i] = requirements.get(i).opening();
        }
        return options(replies, 0);
    }

    /** The system's moves after an input; the last one is to err, where all allow that. */
    List<Option> options(int position, Value[] letter) {
        return options(replies(position, letter), held(letter));
    }

    /** What each requirement allows; null where it allows every output, but no error. */
    Reply[] replies(int position, Value[] letter) {
        budget.insist();
        int[] sets = sets(position);
        Reply[] replies = new Reply[requirements.size()];
        for (int i = 0; i < requirements.size(); i++) {
            if (sets[i] != Requirement.CHAOS) {
                replies[i] = requirements.get(i).reply(sets[i], letter);
            }
        }
        return replies;
    }

    /**
     * @param holding what latched ports hold
     */
    private List<Option> options(Reply[] replies, int holding) {
        int[] demands = new int[replies.length];
        int count = 0;
        for (Reply reply : replies) {
            if (reply != null) {
                demands[count++] = reply.list();
            }
        }
        List<Choices.Choice> possible = choices.of(Arrays.copyOf(demands, count));
        List<Option> options = new ArrayList<>(possible.size());
        for (Choices.Choice choice : possible) {
            options.add(new Option(choice.sent(), after(replies, choice, holding)));
        }
        if (count == replies.length && Arrays.stream(replies).allMatch(Reply::mayEnd)) {
            options.add(Option.ERROR);
        }
        return options;
    }

    private int after(Reply[] replies, Choices.Choice choice, int holding) {
        int[] next = new int[replies.length + 1];
        int asked = 0;
        boolean free = true;
        for (int i = 0; i < replies.length; i++) {
            next[i] =
                    replies[i] == null
                            ? Requirement.CHAOS
                            : requirements.get(i).successor(replies[i], choice.allowed()[asked++]);
            free &= next[i] == Requirement.CHAOS;
        }
        next[replies.length] = holding;
        return free ? FREE : positions.number(new IntKey(next));
    }
}
