package arcomat.analysis.game;

import arcomat.analysis.search.Budget;
import arcomat.analysis.search.MacroStates;
import arcomat.analysis.search.letter.Alphabet;
import arcomat.analysis.search.letter.LetterClasses;
import arcomat.analysis.search.step.OutputCubes;
import arcomat.analysis.search.step.Steps;
import arcomat.analysis.search.system.AutomataSystem;
import arcomat.analysis.search.system.RunErrors;
import arcomat.analysis.search.system.TransitionSystem;
import arcomat.model.Automaton;
import arcomat.model.Value;
import arcomat.semantics.automaton.Configuration;
import arcomat.semantics.expression.Output;
import arcomat.semantics.value.InputAbstraction;

import com.carrotsearch.hppc.IntArrayList;
import com.carrotsearch.hppc.LongObjectHashMap;

import org.jspecify.annotations.Nullable;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.stream.IntStream;

/**
 * One requirement, followed by what is observed: the set of configurations that it may be in after
 * the inputs and outputs so far (subset construction). Once chaos is among them it asks for nothing
 * any more. MacroStates are numbered, and replies are remembered.
 */
public final class Requirement {
    /** In place of the number of a set: every output is allowed from here on, but no error. */
    static final int CHAOS = -1;

    /**
     * What one requirement allows after one kind of letter: its steps, sorted by what they send.
     *
     * @param number the same for replies that allow the same and lead to the same
     * @param before the steps of each member of the set
     * @param cubes numbers of the distinct output cubes, in text order
     * @param list the number of these cubes as a list
     * @param next per cube the configurations afterwards
     */
    record Reply(int number, List<Part> before, int[] cubes, int list, int[][] next) {

        /** Whether the run may end here, in an error. */
        boolean mayEnd() {
            return Arrays.stream(cubes).anyMatch(cube -> cube == OutputCubes.ERROR);
        }
    }

    /** The steps of one member of the set. */
    record Part(int configuration, Steps steps) {}

    private final AutomataSystem system;
    private final Automaton automaton;
    private final boolean mayErr;
    private final boolean ends;
    private final Choices choices;
    private final Budget budget;
    private final int[] positions;
    private final MacroStates sets = new MacroStates();
    private final LetterClasses.OfConfigurations classes;
    private final List<LongObjectHashMap<Reply>> replies = new ArrayList<>();
    private final Map<List<Object>, Integer> contents = new HashMap<>();
    private @Nullable Reply opening;

    /**
     * @param system what the automaton asks for
     * @param ends whether an error is a way to keep it, where it may err itself
     * @param choices shared by all requirements of a game
     * @param budget of time and memory
     */
    public Requirement(
            AutomataSystem system,
            Automaton automaton,
            boolean ends,
            Choices choices,
            Budget budget) {
        this.budget = budget;
        this.system = system;
        this.automaton = automaton;
        this.mayErr = RunErrors.arePossible(automaton);
        this.ends = ends;
        this.choices = choices;
        this.classes = new LetterClasses.OfConfigurations(system.inputs(), budget);
        this.positions = IntStream.range(0, system.inputs().size()).toArray();
    }

    TransitionSystem system() {
        return system;
    }

    /** The name of the state that it is in; empty where there is only one, or more than one way. */
    Optional<String> state(int set) {
        if (set == CHAOS || automaton.states().size() < 2 || sets.members(set).length > 1) {
            return Optional.empty();
        }
        Configuration only = system.configurations(sets.members(set)[0]).get(0);
        return only.isState()
                ? Optional.of(automaton.states().get(only.state()))
                : Optional.empty();
    }

    /** An output cube by its number; null where the run ends. */
    @Nullable Output sent(int cube) {
        return choices.cube(cube);
    }

    /** Whether an error may be a way to keep it; yes where that is unsure. */
    boolean mayEnd() {
        return mayErr && ends;
    }

    /** Whether there may be inputs that it does not answer at all; yes where that is unsure. */
    boolean mayFail() {
        return mayErr && !ends;
    }

    /** What may be sent before anything is read. */
    Reply opening() {
        if (opening == null) {
            opening = reply(List.of(new Part(-1, system.openings())));
        }
        return opening;
    }

    /** The letters that its members together tell apart. */
    LetterClasses letterClasses(int set) {
        return classes.of(set, this::abstraction);
    }

    /** The letters that it tells apart. */
    Alphabet alphabet(int set) {
        return new Alphabet(
                system.profile(), system.inputs(), List.of(letterClasses(set)), List.of(positions));
    }

    private InputAbstraction abstraction(int set) {
        InputAbstraction all = InputAbstraction.none(positions.length);
        for (int member : sets.members(set)) {
            all = all.and(system.letterClasses(member).abstraction());
        }
        return all;
    }

    /** What may be sent in reaction to a letter. */
    Reply reply(int set, Value[] letter) {
        while (replies.size() <= set) {
            replies.add(new LongObjectHashMap<>(4));
        }
        long kind = letterClasses(set).kind(letter);
        Reply known = replies.get(set).get(kind);
        if (known == null) {
            known = compute(set, letter);
            replies.get(set).put(kind, known);
        }
        return known;
    }

    private Reply compute(int set, Value[] letter) {
        List<Part> parts = new ArrayList<>();
        for (int member : sets.members(set)) {
            parts.add(new Part(member, system.steps(member, letter)));
        }
        return reply(parts);
    }

    private Reply reply(List<Part> parts) {
        IntArrayList cubes = new IntArrayList(2);
        List<IntArrayList> next = new ArrayList<>(2);
        for (Part part : parts) {
            Steps steps = part.steps();
            for (int step = 0; step < steps.size(); step++) {
                budget.insist();
                if (steps.outputs()[step] == OutputCubes.ERROR && !ends) {
                    continue;
                }
                int position = cubes.indexOf(steps.outputs()[step]);
                if (position < 0) {
                    position = cubes.size();
                    cubes.add(steps.outputs()[step]);
                    next.add(new IntArrayList(1));
                }
                if (!next.get(position).contains(steps.next()[step])) {
                    next.get(position).add(steps.next()[step]);
                }
            }
        }
        int[][] lists = next.stream().map(IntArrayList::toArray).toArray(int[][]::new);
        int[] all = cubes.toArray();
        int list = choices.number(all);
        List<Object> content = new ArrayList<>(List.of(list));
        next.forEach(content::add);
        int number = contents.computeIfAbsent(content, each -> contents.size());
        return new Reply(number, parts, all, list, lists);
    }

    /** The set of one configuration. */
    int alone(int configuration) {
        return system.isChaos(configuration) ? CHAOS : sets.singleton(configuration);
    }

    /** Chaos allows all outputs, but no error: others beside it may be what allows one. */
    private boolean isFree(int configuration) {
        return system.isChaos(configuration) && !mayEnd();
    }

    /**
     * The set after a letter was sent.
     *
     * @param allowed positions of the reply's cubes that have the letter; at least one
     */
    int successor(Reply reply, int[] allowed) {
        if (allowed.length == 1 && reply.next()[allowed[0]].length == 1) {
            return alone(reply.next()[allowed[0]][0]);
        }
        IntArrayList members = new IntArrayList(allowed.length);
        for (int cube : allowed) {
            for (int next : reply.next()[cube]) {
                budget.insist();
                if (isFree(next)) {
                    return CHAOS;
                }
                if (!members.contains(next)) {
                    members.add(next);
                }
            }
        }
        return sets.number(members.toArray());
    }
}
