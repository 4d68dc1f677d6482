package arcomat.analysis.game.controller;

import arcomat.model.Automaton;
import arcomat.model.Automaton.Completion;
import arcomat.model.Automaton.Match;
import arcomat.model.Automaton.Send;
import arcomat.model.Automaton.Transition;
import arcomat.model.Expression;
import arcomat.model.Port;
import arcomat.model.Value;
import arcomat.semantics.expression.Output;
import arcomat.semantics.expression.Sent;
import arcomat.source.Span;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.Optional;
import java.util.Set;

/**
 * A machine as an automaton that people can read: states that do the same are one, inputs with the
 * same reaction share a transition, and where nothing is sent and the state is kept, there is none
 * at all if the completion says just that.
 */
public final class Controllers {
    /** More states are not compared with each other. */
    private static final int FEW_STATES = 2_000;

    private static final int LONGEST_NAME = 30;

    /** A transition without its source. */
    private record Branch(
            List<Match> matches, Optional<Expression> guard, Output sent, int target) {}

    private final MealyMachine machine;
    private final Span place;
    private final boolean errs;
    private final boolean total;

    private Controllers(MealyMachine machine, Span place) {
        this.machine = machine;
        this.place = place;
        this.errs =
                machine.states().stream()
                        .flatMap(state -> state.reactions().stream())
                        .anyMatch(reaction -> reaction.sent() == null);
        this.total = machine.outputs().stream().anyMatch(Port::total);
    }

    /**
     * @param place in models, for what points at the automaton
     */
    public static Automaton of(MealyMachine machine, Span place) {
        return new Controllers(machine, place).automaton();
    }

    /** A total port is never silent, so that with one all inputs have to be handled. */
    private Completion completion() {
        return errs || total ? Completion.ERROR : Completion.IGNORE;
    }

    private Automaton automaton() {
        int[] classes = merge();
        List<Integer> first = new ArrayList<>();
        for (int state = 0; state < classes.length; state++) {
            if (classes[state] == first.size()) {
                first.add(state);
            }
        }
        List<Transition> transitions = new ArrayList<>();
        for (int source = 0; source < first.size(); source++) {
            for (Branch branch : branches(first.get(source), classes)) {
                transitions.add(
                        new Transition(
                                source,
                                branch.target,
                                branch.guard,
                                branch.matches,
                                sends(branch.sent),
                                List.of(),
                                place));
            }
        }
        return new Automaton(
                "",
                completion(),
                Automaton.Omitted.SILENT,
                names(first),
                List.of(),
                List.of(new Automaton.Initial(0, sends(machine.opening()), List.of(), place)),
                transitions,
                place);
    }

    private List<String> names(List<Integer> states) {
        Set<String> names = new LinkedHashSet<>();
        for (int state : states) {
            String hint = machine.states().get(state).name();
            String base = hint.isEmpty() || hint.length() > LONGEST_NAME ? "s" : hint;
            boolean numbered = base.equals("s") && states.size() > 1;
            String name = numbered ? base + names.size() : base;
            for (int i = 2; names.contains(name); i++) {
                name = base + "_" + i;
            }
            names.add(name);
        }
        return List.copyOf(names);
    }

    /** Classes of states that do the same, numbered in the order of their first states. */
    private int[] merge() {
        int count = machine.states().size();
        int[] classes = new int[count];
        if (count > FEW_STATES) {
            java.util.Arrays.setAll(classes, state -> state);
            return classes;
        }
        int known = 1;
        while (true) {
            Map<List<Object>, Integer> numbers = new HashMap<>();
            int[] finer = new int[count];
            for (int state = 0; state < count; state++) {
                List<Object> key = List.of(classes[state], branches(state, classes));
                finer[state] = Objects.requireNonNullElse(numbers.get(key), numbers.size());
                numbers.put(key, finer[state]);
            }
            classes = finer;
            if (numbers.size() == known) {
                return classes;
            }
            known = numbers.size();
        }
    }

    private List<Branch> branches(int number, int[] classes) {
        MealyMachine.State state = machine.states().get(number);
        Map<MealyMachine.Reaction, Integer> numbers = new HashMap<>();
        List<MealyMachine.Reaction> contents = new ArrayList<>();
        int[] cells = new int[state.reactions().size()];
        for (int i = 0; i < cells.length; i++) {
            MealyMachine.Reaction each = state.reactions().get(i);
            MealyMachine.Reaction merged =
                    new MealyMachine.Reaction(
                            each.sent(), each.sent() == null ? 0 : classes[each.next()]);
            cells[i] = Objects.requireNonNullElse(numbers.get(merged), contents.size());
            if (cells[i] == contents.size()) {
                numbers.put(merged, cells[i]);
                contents.add(merged);
            }
        }
        int[] sizes = state.samples().stream().mapToInt(List::size).toArray();
        List<Branch> branches = new ArrayList<>();
        for (BoxCover.Box box : BoxCover.of(sizes, cells)) {
            MealyMachine.Reaction reaction = contents.get(box.content());
            if (!isLeftOut(reaction, classes[number])) {
                branches.add(branch(state, box, reaction));
            }
        }
        return branches;
    }

    private boolean isLeftOut(MealyMachine.Reaction reaction, int own) {
        return completion() == Completion.IGNORE
                ? reaction.next() == own
                        && Objects.requireNonNull(reaction.sent()).ports().stream()
                                .allMatch(Sent.SILENCE::equals)
                : reaction.sent() == null;
    }

    private Branch branch(
            MealyMachine.State state, BoxCover.Box box, MealyMachine.Reaction reaction) {
        List<Match> matches = new ArrayList<>();
        Expression guard = null;
        for (int port = 0; port < box.groups().length; port++) {
            if (box.groups()[port] != null) {
                MessageCondition condition =
                        new MessageCondition(
                                machine.inputs().get(port),
                                state.looks().get(port),
                                state.samples().get(port),
                                box.groups()[port]);
                if (condition.match().isPresent()) {
                    matches.add(condition.match().get());
                } else {
                    guard = MessageCondition.and(guard, condition.guard());
                }
            }
        }
        Output sent = Objects.requireNonNull(reaction.sent()); // others are left out
        return new Branch(matches, Optional.ofNullable(guard), sent, reaction.next());
    }

    private List<Send> sends(Output output) {
        List<Send> sends = new ArrayList<>();
        for (int i = 0; i < machine.outputs().size(); i++) {
            Port port = machine.outputs().get(i);
            List<Value> values = ((Sent.Messages) output.ports().get(i)).values();
            if (!values.isEmpty()) {
                sends.add(
                        new Send(
                                port,
                                new Automaton.Messages(
                                        values.stream()
                                                .<Expression>map(
                                                        v ->
                                                                new Expression.Constant(
                                                                        v, port.type(), place))
                                                .toList())));
            }
        }
        return sends;
    }
}
