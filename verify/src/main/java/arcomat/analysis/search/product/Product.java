package arcomat.analysis.search.product;

import arcomat.analysis.search.Budget;
import arcomat.analysis.search.IntKey;
import arcomat.analysis.search.MacroStates;
import arcomat.analysis.search.Numbering;
import arcomat.analysis.search.Shortcut;
import arcomat.analysis.search.letter.Alphabet;
import arcomat.analysis.search.letter.LetterClasses;
import arcomat.analysis.search.letter.Letters;
import arcomat.analysis.search.letter.Representatives;
import arcomat.analysis.search.step.CubeSplit;
import arcomat.analysis.search.step.OutputCubes;
import arcomat.analysis.search.step.Steps;
import arcomat.analysis.search.system.DataIndependence;
import arcomat.analysis.search.system.TransitionSystem;
import arcomat.analysis.smt.DataStep;
import arcomat.analysis.smt.KnownExamples;
import arcomat.analysis.smt.MessageExamples;
import arcomat.model.Component;
import arcomat.model.Port;
import arcomat.model.Value;

import com.carrotsearch.hppc.LongObjectHashMap;

import org.jspecify.annotations.Nullable;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.stream.IntStream;
import java.util.stream.Stream;

/**
 * The product of the left system with the subset construction of the right one: the letters that a
 * configuration and a macro state tell apart, their steps with these letters, and how what one
 * sends is answered by the other. Remembers what it has computed.
 */
final class Product {
    final TransitionSystem left;
    final TransitionSystem right;
    final OutputCubes outputs;
    final List<Port> observed;
    final MacroStates sets;

    private static final int SINGLE = 1 << 30;

    private final List<Port> inputs;
    private final CubeSplit split;
    private final Budget budget;
    private final boolean mayErr;
    private final int[] leftPositions;
    private final int[] rightPositions;

    /** What the members of a set tell apart, each once. */
    private final Numbering<List<LetterClasses>> classLists = new Numbering<>();

    private final List<Integer> classListOfSet = new ArrayList<>();
    private final DataIndependence data;
    private final StepTable leftSteps = new StepTable();
    private final StepTable rightSteps = new StepTable();
    private final List<LongObjectHashMap<Alphabet>> alphabets = new ArrayList<>();
    private final KnownExamples examples;
    private final Map<List<Object>, Alphabet> calculated = new HashMap<>();
    private final LongObjectHashMap<Alphabet> calculatedOfPairs = new LongObjectHashMap<>();
    private Optional<String> missing = Optional.empty();
    private final Numbering<IntKey> answerLists = new Numbering<>();
    private final LongObjectHashMap<List<CubeSplit.Case>> cases = new LongObjectHashMap<>();

    /**
     * @param observed the output ports that both have, as cubes name them
     */
    Product(
            TransitionSystem left,
            TransitionSystem right,
            List<Port> observed,
            OutputCubes outputs,
            Budget budget) {
        this(left, right, observed, outputs, budget, new MacroStates());
    }

    private Product(
            TransitionSystem left,
            TransitionSystem right,
            List<Port> observed,
            OutputCubes outputs,
            Budget budget,
            MacroStates sets) {
        this.sets = sets;
        this.budget = budget;
        this.left = left;
        this.right = right;
        this.outputs = outputs;
        this.observed = observed;
        this.mayErr = left.mayErr();
        this.examples = new KnownExamples(budget::isSpent);
        this.data = new DataIndependence(left, right, observed.size());
        boolean events = left.profile() == Component.Profile.EVENT_DRIVEN;
        this.split = new CubeSplit(observed, outputs, events, budget);
        this.inputs = Letters.compared(left.inputs(), right.inputs());
        List<String> names = inputs.stream().map(Port::name).toList();
        leftPositions = IntStream.range(0, names.size()).toArray();
        rightPositions =
                right.inputs().stream().mapToInt(port -> names.indexOf(port.name())).toArray();
    }

    /** With another left side, beside the same sets of the right one. */
    Product with(TransitionSystem other) {
        return new Product(other, right, observed, outputs, budget, sets);
    }

    /** Whether there are data of which it only matters which are the same. */
    boolean hasFreeData() {
        return data.any();
    }

    /** Whether nothing can be forbidden any more: chaos allows all outputs, but no error. */
    boolean isSettled(int rightConfiguration) {
        return !mayErr && right.isChaos(rightConfiguration) && budget.takes(Shortcut.CHAOS);
    }

    /** Whether the right side may be in chaos, of a macro state. */
    boolean isInChaos(int set) {
        for (int member : sets.members(set)) {
            if (right.isChaos(member)) {
                return true;
            }
        }
        return false;
    }

    /** The messages of a letter of the left side that the right side knows. */
    Value[] rightLetter(Value[] letter) {
        Value[] own = new Value[rightPositions.length];
        for (int i = 0; i < own.length; i++) {
            own[i] = letter[rightPositions[i]];
        }
        return own;
    }

    /**
     * Why some letters that are told apart have been left out: what was found is so, but there may
     * be more. Empty where none was.
     */
    Optional<String> missing() {
        return missing;
    }

    /** The letters that a configuration and a set tell apart. */
    Alphabet alphabet(int configuration, int set) {
        LetterClasses own = left.letterClasses(configuration);
        int list = classList(set);
        int held = data.any() ? data.held(configuration, sets.members(set)) : 0;
        return calculates(configuration, set)
                ? calculated(configuration, set, own, list, held)
                : known(own, list, held);
    }

    /**
     * Whether messages of too many values are calculated with, so that letters depend on all that a
     * configuration is in.
     */
    boolean calculates(int configuration, int set) {
        return left.letterClasses(configuration).calculates(data::isFree)
                || classLists.get(classList(set)).stream()
                        .anyMatch(one -> one.calculates(i -> data.isFree(rightPositions[i])));
    }

    private Alphabet known(LetterClasses own, int list, int held) {
        while (alphabets.size() <= held) {
            alphabets.add(new LongObjectHashMap<>(2));
        }
        long key = (long) own.number() << 32 | list;
        Alphabet known = alphabets.get(held).get(key);
        if (known == null) {
            known = alphabet(own, list, held, Optional.empty());
            alphabets.get(held).put(key, known);
        }
        return known;
    }

    /**
     * @param examples of messages that are calculated with; empty where there are none
     */
    private Alphabet alphabet(
            LetterClasses own, int list, int held, Optional<MessageExamples.Source> examples) {
        List<LetterClasses> all = new ArrayList<>(List.of(own));
        all.addAll(classLists.get(list));
        List<int[]> positions = new ArrayList<>(List.of(leftPositions));
        classLists.get(list).forEach(each -> positions.add(rightPositions));
        Representatives representatives =
                data.any() ? data.representatives(held) : Representatives.NONE;
        return new Alphabet(left.profile(), inputs, all, positions, representatives, examples);
    }

    /** Of messages that are calculated with, those that a configuration and a set tell apart. */
    private Alphabet calculated(int configuration, int set, LetterClasses own, int list, int held) {
        long pair = (long) configuration << 32 | set;
        Alphabet known = calculatedOfPairs.get(pair);
        if (known == null) {
            Optional<List<DataStep>> steps = steps(configuration, set);
            List<Object> key = List.of(own.number(), list, held, steps);
            known =
                    calculated.computeIfAbsent(
                            key, each -> alphabet(own, list, held, steps.map(examples::of)));
            calculatedOfPairs.put(pair, known);
            missing = missing.or(known::missing);
        }
        return known;
    }

    /** The steps of both sides, as far as they can be told as expressions. */
    private Optional<List<DataStep>> steps(int configuration, int set) {
        Optional<List<DataStep>> all = left.dataSteps(configuration);
        for (int member : sets.members(set)) {
            Optional<List<DataStep>> more = right.dataSteps(member);
            all =
                    all.flatMap(
                            some ->
                                    more.map(
                                            others ->
                                                    Stream.concat(some.stream(), others.stream())
                                                            .toList()));
        }
        return all;
    }

    private int classList(int set) {
        while (classListOfSet.size() <= set) {
            classListOfSet.add(-1);
        }
        int known = classListOfSet.get(set);
        if (known < 0) {
            List<LetterClasses> distinct = new ArrayList<>();
            for (int member : sets.members(set)) {
                LetterClasses classes = right.letterClasses(member);
                if (!distinct.contains(classes)) {
                    distinct.add(classes);
                }
            }
            known = classLists.number(distinct);
            classListOfSet.set(set, known);
        }
        return known;
    }

    /** Which of an alphabet's classes is that of a member of the set. */
    int classesIndex(int set, int member) {
        return 1 + classLists.get(classList(set)).indexOf(right.letterClasses(member));
    }

    /** The steps of the left side with each letter of an alphabet that is made for it. */
    Steps[] leftSteps(int configuration, Alphabet alphabet) {
        Steps[] known = leftSteps.find(configuration, alphabet);
        if (known == null) {
            known = new Steps[alphabet.size()];
            for (int letter = 0; letter < known.length; letter++) {
                budget.insist();
                known[letter] =
                        left.steps(
                                configuration, alphabet.kind(0, letter), alphabet.letter(letter));
            }
            leftSteps.add(configuration, alphabet, known);
        }
        return known;
    }

    /**
     * The steps of a member of a set with each letter of an alphabet that is made for the set. An
     * event on a port that the right side does not have is an empty letter for it.
     */
    Steps[] rightSteps(int set, int member, Alphabet alphabet) {
        Steps[] known = rightSteps.find(member, alphabet);
        if (known == null) {
            known = new Steps[alphabet.size()];
            int classes = classesIndex(set, member);
            for (int letter = 0; letter < known.length; letter++) {
                budget.insist();
                Value[] own = rightLetter(alphabet.letter(letter));
                known[letter] = right.steps(member, alphabet.kind(classes, letter), own);
            }
            rightSteps.add(member, alphabet, known);
        }
        return known;
    }

    /** The steps of all members of a set. */
    Steps answers(int set, Alphabet alphabet, int letter) {
        int[] members = sets.members(set);
        if (members.length == 1) {
            return answers(set, members[0], alphabet, letter);
        }
        List<Steps> all = new ArrayList<>(members.length);
        for (int member : members) {
            all.add(answers(set, member, alphabet, letter));
        }
        return Steps.union(all);
    }

    Steps answers(int set, int member, Alphabet alphabet, int letter) {
        return rightSteps(set, member, alphabet)[letter];
    }

    /** The set after some of the steps; -1 where it holds chaos and nothing can be forbidden. */
    int successor(Steps theirs, int[] allowed) {
        if (allowed.length == 1) {
            theirs.use(allowed[0]);
            int next = theirs.next()[allowed[0]];
            return isSettled(next) ? -1 : sets.singleton(next);
        }
        int[] members = new int[allowed.length];
        for (int i = 0; i < members.length; i++) {
            budget.insist();
            theirs.use(allowed[i]);
            members[i] = theirs.next()[allowed[i]];
            if (isSettled(members[i])) {
                return -1;
            }
        }
        return sets.number(members);
    }

    /** How what the left side sends is answered by steps of the right side. */
    List<CubeSplit.Case> cases(int sent, Steps theirs) {
        int[] others = theirs.outputs();
        int answers = number(others);
        long key = (long) sent << 32 | answers;
        List<CubeSplit.Case> known = cases.get(key);
        if (known == null) {
            known = split.cases(sent, others);
            cases.put(key, known);
        }
        return known;
    }

    private int number(int[] others) {
        if (others.length == 1) {
            return SINGLE | others[0];
        }
        return answerLists.number(new IntKey(others));
    }

    /** Steps by configuration and alphabet; most configurations meet very few alphabets. */
    private static final class StepTable {
        private record Row(Alphabet alphabet, Steps[] steps, @Nullable Row next) {}

        private Row[] first = new Row[64];

        /** Null where there are none yet. */
        Steps @Nullable [] find(int configuration, Alphabet alphabet) {
            Row row = configuration < first.length ? first[configuration] : null;
            while (row != null && row.alphabet != alphabet) {
                row = row.next;
            }
            return row == null ? null : row.steps;
        }

        void add(int configuration, Alphabet alphabet, Steps[] steps) {
            if (configuration >= first.length) {
                first = Arrays.copyOf(first, Math.max(configuration + 1, 2 * first.length));
            }
            first[configuration] = new Row(alphabet, steps, first[configuration]);
        }
    }
}
