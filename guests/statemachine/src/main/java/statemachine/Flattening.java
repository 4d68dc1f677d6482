package statemachine;

import arcomat.guest.Meaning;
import arcomat.source.Span;
import arcomat.tree.Name;

import statemachine.Entering.Way;
import statemachine.Machine.Action;
import statemachine.Machine.Beginning;
import statemachine.Machine.Item;
import statemachine.Machine.Label;
import statemachine.Machine.State;
import statemachine.Machine.Target;
import statemachine.Machine.Transition;

import java.util.ArrayList;
import java.util.Collection;
import java.util.Collections;
import java.util.List;
import java.util.Optional;
import java.util.stream.Collectors;

/**
 * A machine as an automaton: its states are the simple ones, and each has the transitions of all
 * states that it stands in. What is written letter by letter keeps its place.
 */
final class Flattening {
    /** Beyond that nobody has written it, and nobody could wait for an answer about it. */
    private static final int MOST = 10_000;

    private final Machine machine;
    private final StateTree states;
    private final Meaning meaning;
    private final StepActions actions;
    private final Entering entering;

    Flattening(Machine machine, StateTree states, Meaning meaning) {
        this.machine = machine;
        this.states = states;
        this.meaning = meaning;
        this.actions = new StepActions(machine.variables(), meaning);
        this.entering = new Entering(states);
    }

    /** A transition out of one simple state. */
    record Arrow(Transition transition, State source, List<State> left, Way way) {
        /** Of one that leads somewhere. */
        State goal(StateTree states) {
            return states.state(transition.target().orElseThrow().state());
        }

        Arrow after(List<Integer> last) {
            return new Arrow(transition, source, left, way.after(last));
        }
    }

    void write() {
        List<Arrow> all = arrows();
        if (all.size() > MOST) {
            Mistake.TOO_LARGE.tell(
                    meaning,
                    machine.root().name().place(),
                    "this machine has more than %d transitions between its simple states;"
                            + " make several of it",
                    MOST);
            return;
        }
        Histories histories = Histories.of(all, states, entering);
        List<Arrow> arrows =
                all.stream().flatMap(each -> histories.possible(each).stream()).toList();
        Remembered remembered = Remembered.by(arrows, states, entering);
        variables(remembered);
        states.leaves(states.root()).forEach(this::state);
        meaning.within(List.of());
        beginning();
        arrows.forEach(each -> arrow(each, remembered));
        states.leaves(states.root()).forEach(this::during);
    }

    /** As many as may be, and some more if there are more. */
    private List<Arrow> arrows() {
        List<Arrow> arrows = new ArrayList<>();
        for (State leaf : states.leaves(states.root())) {
            for (Transition each : states.transitions()) {
                if (states.isIn(leaf, states.state(each.source()))) {
                    arrows.addAll(arrows(leaf, each));
                }
                if (arrows.size() > MOST) {
                    return arrows;
                }
            }
        }
        return arrows;
    }

    private List<Arrow> arrows(State leaf, Transition transition) {
        if (transition.target().isEmpty()) {
            return List.of(
                    new Arrow(transition, leaf, List.of(), new Way(leaf, List.of(), List.of())));
        }
        Target target = transition.target().get();
        State source = states.state(transition.source());
        State goal = states.state(target.state());
        int around = states.around(source, goal);
        List<State> left = from(around, states.path(leaf));
        Optional<State> current = left.contains(goal) ? Optional.of(leaf) : Optional.empty();
        List<Way> ways = entering.into(from(around, states.path(goal)), target.memory(), current);
        List<Arrow> arrows = new ArrayList<>();
        ways.forEach(way -> arrows.add(new Arrow(transition, leaf, left, way)));
        return arrows;
    }

    private static List<State> from(int start, List<State> path) {
        return path.subList(start, path.size());
    }

    private void variables(Remembered remembered) {
        for (Span each : machine.declarations()) {
            meaning.element(each).write(each, "%s", each.text());
        }
        for (State each : remembered.byName().values()) {
            Span place = each.name().place();
            meaning.element(place).write(place, "%s", remembered.declaration(each));
        }
    }

    private void state(State leaf) {
        Label name = leaf.name();
        List<State> path = states.path(leaf);
        meaning.within(
                path.subList(0, path.size() - 1).stream()
                        .map(each -> new Name(each.name().place(), each.name().text()))
                        .toList());
        meaning.element(name.place())
                .write(name.place(), "state ")
                .write(name.place(), "%s", name.text())
                .write(name.place(), ";");
    }

    private void beginning() {
        Beginning initial = machine.root().initial().orElseThrow();
        Way way = entering.beginning();
        meaning.element(initial.place()).write(initial.place(), "initial ");
        name(way.leaf(), initial.state(), initial.place());
        output(way.actions(), List.of(), initial.place());
        meaning.write(initial.place(), ";");
    }

    private void arrow(Arrow arrow, Remembered remembered) {
        Transition transition = arrow.transition();
        Span place = transition.place();
        meaning.element(place).rank(rank(states.state(transition.source())));
        name(arrow.source(), transition.source(), place);
        transition
                .target()
                .ifPresent(
                        target -> {
                            meaning.write(place, " -> ");
                            name(arrow.way().leaf(), target.state(), place);
                        });
        meaning.write(place, " ");
        transition.guard().ifPresent(guard -> meaning.write(guard, "%s", guard.text()));
        input(arrow, remembered);
        List<Action> done = new ArrayList<>();
        List<State> left = new ArrayList<>(arrow.left());
        Collections.reverse(left);
        left.forEach(each -> each.exit().ifPresent(done::add));
        transition.output().ifPresent(done::add);
        done.addAll(arrow.way().actions());
        output(done, remembered.noted(arrow.source(), arrow.left()), place);
        meaning.write(place, ";");
    }

    /** Smaller comes first: the deeper or the less deep, as the machine says. */
    private int rank(State source) {
        int depth = states.path(source).size();
        return switch (machine.priority()) {
            case OPEN -> 0;
            case INNER -> states.deepest() - depth;
            case OUTER -> depth - 1;
        };
    }

    /** A step that comes behind all others. */
    private void during(State leaf) {
        List<Action> done = new ArrayList<>();
        List<Span> places = new ArrayList<>();
        for (State each : states.path(leaf)) {
            each.during().ifPresent(during -> done.add(during.action()));
            each.during().ifPresent(during -> places.add(during.place()));
        }
        if (!done.isEmpty()) {
            Span place = places.get(places.size() - 1);
            meaning.element(place).rank(states.deepest());
            meaning.write(place, "%s", leaf.name().text());
            output(done, List.of(), place);
            meaning.write(place, ";");
        }
    }

    /** A name that stands in the text keeps its place; others have that of the whole. */
    private void name(State state, Label written, Span whole) {
        boolean same = state.name().text().equals(written.text());
        meaning.write(same ? written.place() : whole, "%s", state.name().text());
    }

    /** What was the last is asked like a message: guards may be long, and stay as they are. */
    private void input(Arrow arrow, Remembered remembered) {
        Transition transition = arrow.transition();
        Optional<Span> written = transition.input();
        if (arrow.way().last().isEmpty()) {
            written.ifPresent(input -> meaning.write(input, "%s", input.text()));
            return;
        }
        Span place = transition.place();
        State goal = arrow.goal(states);
        String numbers =
                remembered.values(goal, arrow.way().last()).stream()
                        .map(String::valueOf)
                        .collect(Collectors.joining(", "));
        meaning.write(place, "{%s == alt {%s}", Remembered.variable(goal), numbers);
        if (written.isPresent()) {
            Span inside = inside(written.get());
            meaning.write(place, inside.text().isBlank() ? "" : ", ");
            meaning.write(inside, "%s", inside.text());
        }
        meaning.write(place, "}");
    }

    private static Span inside(Span braces) {
        return new Span(braces.file(), braces.start() + 1, braces.end() - 1);
    }

    private void output(List<Action> done, List<Remembered.Value> noted, Span place) {
        Collection<Item> items = actions.together(done);
        if (items.isEmpty() && noted.isEmpty()) {
            return;
        }
        String separator = " / {";
        for (Item each : items) {
            meaning.write(place, separator).write(each.place(), "%s", each.place().text());
            separator = ", ";
        }
        for (Remembered.Value each : noted) {
            meaning.write(place, "%s%s = %d", separator, each.variable(), each.number());
            separator = ", ";
        }
        meaning.write(place, "}");
    }
}
