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
import arcomat.model.Component;
import arcomat.model.Port;
import arcomat.model.Value;

import com.carrotsearch.hppc.LongObjectHashMap;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;

/**
 * What a comparison of two sides remembers besides them: letters that both tell apart, steps of
 * sets, and how outputs of one are answered by the other.
 */
final class Product {
    final TransitionSystem left;
    final TransitionSystem right;
    final OutputCubes outputs;
    final MacroStates sets = new MacroStates();

    private static final int SINGLE = 1 << 30;

    private final List<Port> inputs;
    private final List<Port> observed;
    private final CubeSplit split;
    private final Budget budget;
    private final boolean mayErr;
    private final int[] leftPositions;
    private final int[] rightPositions;
    private final Map<List<Integer>, Integer> focusLists = new HashMap<>();
    private final List<List<LetterClasses>> foci = new ArrayList<>();
    private final List<Integer> focusListOfSet = new ArrayList<>();
    private final DataIndependence data;
    private final List<LongObjectHashMap<Alphabet>> alphabets = new ArrayList<>();
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
        this.budget = budget;
        this.left = left;
        this.right = right;
        this.outputs = outputs;
        this.observed = observed;
        this.mayErr = left.mayErr();
        this.data = new DataIndependence(left, right, observed.size());
        boolean events = left.profile() == Component.Profile.EVENT_DRIVEN;
        this.split = new CubeSplit(observed, outputs, events, budget);
        this.inputs = Letters.compared(left.inputs(), right.inputs());
        List<String> names = inputs.stream().map(Port::name).toList();
        leftPositions = java.util.stream.IntStream.range(0, names.size()).toArray();
        rightPositions =
                right.inputs().stream().mapToInt(port -> names.indexOf(port.name())).toArray();
    }

    /** Whether nothing can be forbidden any more: chaos allows all outputs, but no error. */
    boolean isSettled(int rightConfiguration) {
        return !mayErr && right.isChaos(rightConfiguration) && budget.takes(Shortcut.CHAOS);
    }

    private final StepTable leftRows = new StepTable();
    private final StepTable rightRows = new StepTable();

    /** The messages of a letter of the left side that the right side knows. */
    Value[] rightLetter(Value[] letter) {
        Value[] own = new Value[rightPositions.length];
        for (int i = 0; i < own.length; i++) {
            own[i] = letter[rightPositions[i]];
        }
        return own;
    }

    /** The letters that a configuration and a set tell apart. */
    Alphabet alphabet(int configuration, int set) {
        LetterClasses own = left.focus(configuration);
        int list = focusList(set);
        int held = data.any() ? data.held(configuration, sets.members(set)) : 0;
        while (alphabets.size() <= held) {
            alphabets.add(new LongObjectHashMap<>(2));
        }
        long key = (long) own.number() << 32 | list;
        Alphabet known = alphabets.get(held).get(key);
        if (known == null) {
            List<LetterClasses> all = new ArrayList<>(List.of(own));
            all.addAll(foci.get(list));
            List<int[]> positions = new ArrayList<>(List.of(leftPositions));
            foci.get(list).forEach(each -> positions.add(rightPositions));
            Representatives standIns = data.any() ? data.standIns(held) : Representatives.NONE;
            known = new Alphabet(left.profile(), inputs, all, positions, standIns);
            alphabets.get(held).put(key, known);
        }
        return known;
    }

    private int focusList(int set) {
        while (focusListOfSet.size() <= set) {
            focusListOfSet.add(-1);
        }
        int known = focusListOfSet.get(set);
        if (known < 0) {
            List<LetterClasses> distinct = new ArrayList<>();
            for (int member : sets.members(set)) {
                LetterClasses focus = right.focus(member);
                if (!distinct.contains(focus)) {
                    distinct.add(focus);
                }
            }
            known =
                    focusLists.computeIfAbsent(
                            distinct.stream().map(LetterClasses::number).toList(),
                            key -> {
                                foci.add(distinct);
                                return foci.size() - 1;
                            });
            focusListOfSet.set(set, known);
        }
        return known;
    }

    /** Which of an alphabet's foci is that of a member of the set. */
    int focusIndex(int set, int member) {
        return 1 + foci.get(focusList(set)).indexOf(right.focus(member));
    }

    /** The steps of the left side with each letter of an alphabet that is made for it. */
    Steps[] leftSteps(int configuration, Alphabet alphabet) {
        Steps[] known = leftRows.find(configuration, alphabet);
        if (known == null) {
            known = new Steps[alphabet.size()];
            for (int letter = 0; letter < known.length; letter++) {
                budget.insist();
                known[letter] =
                        left.steps(
                                configuration, alphabet.kind(0, letter), alphabet.letter(letter));
            }
            leftRows.add(configuration, alphabet, known);
        }
        return known;
    }

    /**
     * The steps of a member of a set with each letter of an alphabet that is made for the set. An
     * event on a port that the right side does not have is an empty letter for it.
     */
    Steps[] rightSteps(int set, int member, Alphabet alphabet) {
        Steps[] known = rightRows.find(member, alphabet);
        if (known == null) {
            known = new Steps[alphabet.size()];
            int focus = focusIndex(set, member);
            for (int letter = 0; letter < known.length; letter++) {
                budget.insist();
                Value[] own = rightLetter(alphabet.letter(letter));
                known[letter] = right.steps(member, alphabet.kind(focus, letter), own);
            }
            rightRows.add(member, alphabet, known);
        }
        return known;
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
}
