package montiarc7;

import montiarc7.Machine.State;
import montiarc7.grammar.MontiArc7Parser.BlockContext;
import montiarc7.grammar.MontiArc7Parser.ExpressionContext;
import montiarc7.source.Lack;
import montiarc7.statement.ActionWriter;
import montiarc7.statement.ExpressionWriter;
import montiarc7.statement.Guards;
import montiarc7.statement.Scope;

import org.antlr.v4.runtime.ParserRuleContext;

import java.util.ArrayList;
import java.util.Collections;
import java.util.HashSet;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.regex.Pattern;
import java.util.stream.Collectors;
import java.util.stream.Stream;

/**
 * An automaton whose states stand beside each other. What a transition leaves and enters is done in
 * its action; of several that are enabled the first one of the innermost state is taken, so the
 * guards of those behind it say that it is not.
 */
final class MachineWriter {
    private final Machine machine;
    private final MontiArcText text;
    private final Scope scope;
    private final boolean events;

    /**
     * @param events whether steps are events, and not slices
     */
    MachineWriter(Machine machine, MontiArcText text, Scope scope, boolean events) {
        this.machine = machine;
        this.text = text;
        this.scope = scope;
        this.events = events;
    }

    /**
     * Actions at the beginning, one after the other, where ports with a delay show what they send.
     */
    String write(Optional<BlockContext> before, Set<String> delayed, ParserRuleContext place) {
        StringBuilder written = new StringBuilder("<<completion = \"ignore\">> automaton {\n");
        List<State> states = machine.resting();
        if (states.isEmpty() || machine.initial().isEmpty()) {
            scope.lacks()
                    .missing(Lack.STRUCTURE, place, "the automaton has no initial state; mark one");
            return "";
        }
        List<State> entered = Machine.beginning(machine.initial().get());
        State first = entered.get(entered.size() - 1);
        List<ParserRuleContext> actions = new ArrayList<>();
        before.ifPresent(actions::add);
        entered.forEach(each -> each.beginning().ifPresent(actions::add));
        List<ParserRuleContext> entries = new ArrayList<>();
        entered.forEach(each -> add(entries, each, "entry"));
        boolean isLate = !events && entriesAreSeen(entries);
        if (!isLate) {
            actions.addAll(entries);
        }
        String start = new StartWriter(scope, delayed).write(actions);
        String initial = isLate ? first.name + "AtFirst" : first.name;
        written.append("state ").append(isLate ? initial + ", " : "");
        written.append(states.stream().map(each -> each.name).collect(Collectors.joining(", ")));
        written.append(";\ninitial ").append(initial);
        written.append(start.isBlank() ? ";\n" : " / do {" + start + "};\n");
        if (isLate) {
            written.append(from(first, initial, entries));
        }
        states.forEach(each -> written.append(from(each, each.name, List.of())));
        return written.append("}\n").toString();
    }

    /**
     * What the first state does when it is entered is a matter of the first slice, and seen there;
     * what nobody sees may as well be done before.
     */
    private boolean entriesAreSeen(List<ParserRuleContext> entries) {
        ActionWriter writer = new ActionWriter(scope);
        if (entries.stream().allMatch(each -> !writer.sends(each))) {
            return false;
        }
        String guards =
                machine.transitions().stream()
                        .filter(each -> each.guard() != null)
                        .map(each -> each.guard().getText())
                        .collect(Collectors.joining(" "));
        for (ParserRuleContext each : entries) {
            for (String name : writer.assigned(each)) {
                if (guards.matches("(?s).*\\b" + Pattern.quote(name) + "\\b.*")) {
                    scope.lacks()
                            .missing(
                                    Lack.STATEMENT,
                                    each,
                                    "the entry of the first state sends, and changes '%s', which guards read in the same slice"
                                            .formatted(name));
                }
            }
        }
        return true;
    }

    /**
     * The steps from a state.
     *
     * @param name of the state, or of one that stands for it in the first slice
     * @param entries what is done before, in the first slice
     */
    private String from(State state, String name, List<ParserRuleContext> entries) {
        StringBuilder written = new StringBuilder();
        List<Transition> before = new ArrayList<>();
        for (State level : state.outwards()) {
            for (Transition each : machine.from(level)) {
                written.append(transition(new Step(state, name, entries, level), each, before));
                before.add(each);
            }
        }
        List<ParserRuleContext> actions = new ArrayList<>(entries);
        actions.addAll(meanwhile(state));
        if (!actions.isEmpty()) {
            written.append(stay(state, name, actions, before));
        }
        return written.toString();
    }

    /**
     * Where a transition begins.
     *
     * @param source the state itself, or one around it
     */
    private record Step(State state, String name, List<ParserRuleContext> entries, State source) {
        boolean isAsWritten() {
            return state == source && entries.isEmpty();
        }
    }

    /** What is done at the end of a slice in a state, from the outside in. */
    private List<ParserRuleContext> meanwhile(State state) {
        List<ParserRuleContext> actions = new ArrayList<>();
        List<State> inwards = new ArrayList<>(state.outwards());
        Collections.reverse(inwards);
        inwards.forEach(each -> add(actions, each, "do"));
        if (events && !actions.isEmpty()) {
            scope.lacks()
                    .missing(
                            Lack.STATEMENT,
                            state.place,
                            "'do' needs slices, and this automaton works by events");
        }
        return actions;
    }

    private String stay(
            State state, String name, List<ParserRuleContext> actions, List<Transition> before) {
        String done = new ActionWriter(scope).write(actions);
        return guard(null, before, Set.of())
                .map(each -> "%s -> %s%s / do {%s};%n".formatted(name, state.name, each, done))
                .orElse("");
    }

    private String transition(Step step, Transition transition, List<Transition> before) {
        Optional<State> target = machine.target(transition);
        if (target.isEmpty()) {
            return "";
        }
        Scope inside = scope.with(present(transition));
        List<Transition> same =
                before.stream()
                        .filter(each -> each.trigger().equals(transition.trigger()))
                        .toList();
        Optional<String> guard = guard(transition, same, present(transition));
        if (guard.isEmpty()) {
            if (step.isAsWritten()) {
                scope.lacks()
                        .note(
                                Lack.NEVER,
                                transition.place(),
                                "this transition is never taken, one before it always is; it is"
                                        + " left out");
            }
            return "";
        }
        List<State> entered = Machine.beginning(target.get());
        State end = entered.get(entered.size() - 1);
        StringBuilder written =
                new StringBuilder(step.isAsWritten() ? text.comments(transition.place()) : "");
        written.append(step.name()).append(" -> ").append(end.name).append(guard.get());
        transition.trigger().ifPresent(port -> written.append(" {").append(port).append(" == ?}"));
        List<ParserRuleContext> all = new ArrayList<>(step.entries());
        all.addAll(actions(step.state(), step.source(), transition, target.get()));
        all.addAll(meanwhile(end));
        String done = new ActionWriter(inside).write(all);
        if (!done.isBlank()) {
            written.append(" / do {").append(done).append("}");
        }
        return written.append(";\n").toString();
    }

    /**
     * What is left, from the inside out, what is done, and what is entered, from the outside in.
     */
    private static List<ParserRuleContext> actions(
            State state, State source, Transition transition, State target) {
        List<State> kept = new ArrayList<>(source.outwards());
        if (!transition.isWithin()) {
            kept.remove(source);
            kept.retainAll(target.outwards());
            kept.remove(target);
        }
        List<ParserRuleContext> actions = new ArrayList<>();
        for (State each : state.outwards()) {
            if (!kept.contains(each)) {
                add(actions, each, "exit");
            }
        }
        if (transition.action() != null) {
            actions.add(transition.action());
        }
        List<State> entered = new ArrayList<>(target.outwards());
        entered.removeAll(kept);
        Collections.reverse(entered);
        List<State> inner = Machine.beginning(target);
        entered.addAll(inner.subList(1, inner.size()));
        entered.forEach(each -> add(actions, each, "entry"));
        return actions;
    }

    private static void add(List<ParserRuleContext> actions, State state, String kind) {
        if (state.actions.containsKey(kind)) {
            actions.add(state.actions.get(kind));
        }
    }

    /** Nothing where a transition before it is always taken. */
    private Optional<String> guard(
            Transition transition, List<Transition> before, Set<String> present) {
        Guards guards = new Guards(new ExpressionWriter(scope));
        ExpressionContext own = transition == null ? null : transition.guard();
        if (before.stream().anyMatch(each -> isAlways(guards, each.guard(), own))) {
            return Optional.empty();
        }
        Stream<String> others =
                before.stream()
                        .map(Transition::guard)
                        .filter(each -> own == null || !guards.exclude(each, own))
                        .map(
                                each ->
                                        guards.notTrue(
                                                each,
                                                own == null ? List.of() : Guards.parts(own),
                                                present));
        List<String> parts = new ArrayList<>();
        if (own != null) {
            String written = new ExpressionWriter(scope).write(own);
            parts.add(before.isEmpty() || !isLoose(own) ? written : "(" + written + ")");
        }
        others.distinct().forEach(parts::add);
        if (parts.size() == 1) {
            parts.set(0, Guards.bare(parts.get(0)));
        }
        return Optional.of(parts.isEmpty() ? "" : " [" + String.join(" && ", parts) + "]");
    }

    private static boolean isAlways(
            Guards guards, ExpressionContext earlier, ExpressionContext own) {
        return earlier == null || own != null && guards.follows(earlier, own);
    }

    private static boolean isLoose(ExpressionContext guard) {
        return guard.getText().contains("||")
                || guard.getText().contains("?")
                || guard.getText().contains("implies")
                || guard.getText().contains("<=>");
    }

    /** Ports that carry a message where a transition is taken. */
    private Set<String> present(Transition transition) {
        Set<String> present =
                transition.guard() == null
                        ? new HashSet<>()
                        : new Guards(new ExpressionWriter(scope)).presentIn(transition.guard());
        transition.trigger().ifPresent(present::add);
        return present;
    }
}
