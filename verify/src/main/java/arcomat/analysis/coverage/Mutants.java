package arcomat.analysis.coverage;

import arcomat.analysis.coverage.TransitionTests.Mistake;
import arcomat.model.Automaton;
import arcomat.model.Automaton.Assignment;
import arcomat.model.Automaton.Emission;
import arcomat.model.Automaton.Match;
import arcomat.model.Automaton.Pattern;
import arcomat.model.Automaton.Send;
import arcomat.model.Automaton.Transition;
import arcomat.model.Component;
import arcomat.model.Expression;
import arcomat.model.Port;
import arcomat.model.Type;
import arcomat.model.Value;
import arcomat.semantics.value.SmallType;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.stream.Collectors;

/**
 * Small mistakes in the transitions of an automaton: each is the automaton with one of them, as
 * somebody may have written it instead.
 */
public record Mutants(Component component, Automaton automaton) {
    /** With more states, a transition is led to the next one only. */
    private static final int FEW_STATES = 12;

    /** So many other messages are sent instead. */
    private static final int FEW_MESSAGES = 4;

    /** An automaton with a mistake. */
    public record Mutant(Mistake mistake, Automaton automaton) {}

    /** In the order of the transitions. */
    public List<Mutant> all() {
        List<Mutant> mutants = new ArrayList<>();
        for (int i = 0; i < automaton.transitions().size(); i++) {
            Transition transition = automaton.transitions().get(i);
            mutants.add(mutant("is missing", i, List.of()));
            for (Change change : changes(transition)) {
                mutants.add(mutant(change.what, i, List.of(change.transition)));
            }
        }
        return mutants;
    }

    private Mutant mutant(String what, int index, List<Transition> instead) {
        List<Transition> transitions = replaced(automaton.transitions(), index, instead);
        Mistake mistake = new Mistake(new Goal(automaton, index), what);
        return new Mutant(mistake, automaton.withTransitions(transitions));
    }

    private record Change(String what, Transition transition) {}

    private List<Change> changes(Transition transition) {
        List<Change> changes = new ArrayList<>();
        targets(transition, changes);
        sends(transition, changes);
        matches(transition, changes);
        guard(transition, changes);
        assignments(transition, changes);
        return changes;
    }

    private void targets(Transition t, List<Change> changes) {
        int states = automaton.states().size();
        int most = states > FEW_STATES ? 1 : states - 1;
        for (int i = 1; i <= most; i++) {
            int target = (t.target() + i) % states;
            String what = "leads to '" + automaton.states().get(target) + "'";
            changes.add(new Change(what, t.between(t.source(), target)));
        }
    }

    private void sends(Transition t, List<Change> changes) {
        for (int i = 0; i < t.sends().size(); i++) {
            Send send = t.sends().get(i);
            for (Emission other : others(send)) {
                String what = sends(other, send.port());
                List<Send> sends = replaced(t.sends(), i, List.of(new Send(send.port(), other)));
                changes.add(new Change(what, with(t, t.guard(), t.matches(), sends)));
            }
        }
    }

    private static String sends(Emission emission, Port port) {
        String what = emission.values().isEmpty() ? "nothing" : text(emission.values().get(0));
        return "sends %s on '%s'".formatted(what, port.name());
    }

    private static String text(Expression value) {
        return value instanceof Expression.Constant constant
                ? constant.value().toString()
                : "something else";
    }

    private List<Emission> others(Send send) {
        List<Emission> others = new ArrayList<>();
        Port port = send.port();
        if (!port.total() && !(send.emission() instanceof Automaton.Silence)) {
            others.add(new Automaton.Silence());
        }
        for (Value value : some(port.type())) {
            if (!isSame(send.emission(), value)) {
                Expression constant = new Expression.Constant(value, port.type(), component.span());
                others.add(new Automaton.Messages(List.of(constant)));
            }
        }
        return others;
    }

    private static boolean isSame(Emission emission, Value value) {
        return emission.values().size() == 1
                && emission.values().get(0) instanceof Expression.Constant constant
                && constant.value().equals(value);
    }

    private static List<Value> some(Type type) {
        boolean words = type instanceof Type.EnumType || type instanceof Type.BooleanType;
        return words
                ? SmallType.values(type).orElseThrow().stream().limit(FEW_MESSAGES).toList()
                : List.of();
    }

    private void matches(Transition t, List<Change> changes) {
        for (int i = 0; i < t.matches().size(); i++) {
            Match match = t.matches().get(i);
            String name = match.port().name();
            changes.add(
                    new Change(
                            "asks nothing of '" + name + "'",
                            with(t, t.guard(), replaced(t.matches(), i, List.of()), t.sends())));
            for (Pattern other : others(match)) {
                List<Match> asked =
                        replaced(t.matches(), i, List.of(new Match(match.port(), other)));
                String what = "asks " + asks(match.port(), other);
                changes.add(new Change(what, with(t, t.guard(), asked, t.sends())));
            }
        }
        for (Port port : component.inputs()) {
            if (t.matches().stream().noneMatch(m -> m.port().name().equals(port.name()))) {
                asksOf(port, t, changes);
            }
        }
    }

    private void asksOf(Port port, Transition t, List<Change> changes) {
        List<Pattern> patterns =
                port.total()
                        ? asked(port.type())
                        : List.of(new Automaton.Present(), new Automaton.Absent());
        for (Pattern pattern : patterns) {
            List<Match> asked = new ArrayList<>(t.matches());
            asked.add(new Match(port, pattern));
            String what = "also asks " + asks(port, pattern);
            changes.add(new Change(what, with(t, t.guard(), asked, t.sends())));
        }
    }

    /**
     * Single messages of a port that always carries one. Of a type with many it is the first, which
     * is what tests have where nothing asks for another one.
     */
    private List<Pattern> asked(Type type) {
        boolean isOpen = type instanceof Type.ClassType;
        List<Value> many = isOpen ? List.of() : List.of(type.first());
        List<Value> few = some(type);
        return (few.isEmpty() ? many : few)
                .stream()
                        .map(value -> new Expression.Constant(value, type, component.span()))
                        .<Pattern>map(value -> new Automaton.OneOf(List.of(value)))
                        .toList();
    }

    /** As models write it, on one line. */
    private static String asks(Port port, Pattern pattern) {
        return port.name() + " == " + pattern.match(Mutants::asks, () -> "--", () -> "?");
    }

    private static String asks(Automaton.OneOf oneOf) {
        String values =
                oneOf.values().stream().map(Mutants::text).collect(Collectors.joining(", "));
        return oneOf.values().size() > 1 ? "alt {" + values + "}" : values;
    }

    @SuppressWarnings("NullAway") // what nobody has written stands nowhere
    private static List<Pattern> others(Match match) {
        List<Pattern> others = new ArrayList<>();
        List<Expression> values = match.pattern().values();
        for (int i = 0; values.size() > 1 && i < values.size(); i++) {
            others.add(new Automaton.OneOf(replaced(values, i, List.of())));
        }
        if (!(match.pattern() instanceof Automaton.Present)) {
            others.add(new Automaton.Present());
        }
        if (!(match.pattern() instanceof Automaton.Absent) && !match.port().total()) {
            others.add(new Automaton.Absent());
        }
        if (match.pattern() instanceof Automaton.Present) {
            for (Value value : some(match.port().type())) {
                Type type = match.port().type();
                others.add(
                        new Automaton.OneOf(List.of(new Expression.Constant(value, type, null))));
            }
        }
        return others;
    }

    private static void guard(Transition t, List<Change> changes) {
        if (t.guard().isPresent()) {
            changes.add(
                    new Change("has no guard", with(t, Optional.empty(), t.matches(), t.sends())));
            for (GuardMutants.Changed other : new GuardMutants(t.guard().get()).all()) {
                changes.add(
                        new Change(
                                other.what(),
                                with(t, Optional.of(other.guard()), t.matches(), t.sends())));
            }
        }
    }

    private static void assignments(Transition t, List<Change> changes) {
        for (int i = 0; i < t.assignments().size(); i++) {
            String name = t.assignments().get(i).variable().name();
            List<Assignment> others = replaced(t.assignments(), i, List.of());
            changes.add(
                    new Change(
                            "leaves '" + name + "' as it is",
                            t.with(t.guard(), t.matches(), t.sends(), others)));
        }
    }

    private static Transition with(
            Transition t, Optional<Expression> guard, List<Match> matches, List<Send> sends) {
        return t.with(guard, matches, sends, t.assignments());
    }

    private static <T> List<T> replaced(List<T> list, int position, List<T> instead) {
        List<T> changed = new ArrayList<>(list);
        changed.remove(position);
        changed.addAll(position, instead);
        return changed;
    }
}
