package arcomat.simulate.watch;

import arcomat.model.Automaton;
import arcomat.model.Component;
import arcomat.model.Letter;
import arcomat.model.Port;
import arcomat.model.Trace;
import arcomat.model.Value;
import arcomat.semantics.automaton.ComponentSemantics;
import arcomat.semantics.automaton.Configuration;
import arcomat.semantics.automaton.StepRelation;
import arcomat.semantics.automaton.StepRelation.Prospect;
import arcomat.semantics.automaton.StepRelation.Reaction;
import arcomat.semantics.automaton.StepRelation.RunError;
import arcomat.semantics.expression.Output;
import arcomat.semantics.expression.Sent;

import java.util.ArrayList;
import java.util.Collections;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Optional;
import java.util.OptionalInt;
import java.util.Set;
import java.util.function.Function;
import java.util.stream.Stream;

/**
 * Watches the ports of a component for one of its automata: the set of its runs that agree with
 * what was seen. What is compared is what is visible in a slice, as in a refinement, so that the
 * delays of what runs do not matter. Generated monitors do the same, see {@code
 * arcomat.rt.Monitor}.
 */
public final class Watch {
    /** With more, the set of runs grows beyond what can be followed. */
    private static final int MOST_WAYS = 100_000;

    private final StepRelation relation;
    private final String requirement;
    private final List<Port> outputs;
    private final WatchedInputs inputs;
    private final boolean timed;
    private final String unit;

    /** Positions of the outputs that show in a slice the reaction to the one before. */
    private final List<Integer> late = new ArrayList<>();

    /** Positions of the outputs that show in a slice, or after an event, the reaction to it. */
    private final List<Integer> instant = new ArrayList<>();

    private List<ConsistentRun> ways = new ArrayList<>();

    /** Why the requirement may have ended in an error in the last step; empty if it may not. */
    private String error = "";

    /** Whether ways have been given up that only matter where the run ends in an error. */
    private boolean lost;

    private boolean violated;
    private Optional<String> unknown = Optional.empty();
    private int number;
    private OptionalInt satisfiedFrom = OptionalInt.empty();

    /** A watch of the component itself. */
    public Watch(Component component, Automaton automaton, List<Value> arguments) {
        this(component, automaton, arguments, component);
    }

    /**
     * @param automaton one of those of the component
     * @param arguments one per parameter
     * @param running what is watched: the same component, or one that has its ports
     */
    public Watch(
            Component component, Automaton automaton, List<Value> arguments, Component running) {
        Component asked = component.asPromised();
        relation = ComponentSemantics.of(asked, List.of(automaton), arguments).relations().get(0);
        int line = automaton.span().startPosition().line();
        requirement = component.title(automaton) + " (line " + line + ")";
        outputs = asked.outputs();
        inputs = new WatchedInputs(component, running);
        timed = component.profile() == Component.Profile.TIME_SYNCHRONOUS;
        unit = timed ? "slice " : "event ";
        for (int i = 0; i < outputs.size(); i++) {
            (timed && outputs.get(i).delay() > 0 ? late : instant).add(i);
        }
        relation.starts().forEach(start -> ways.add(ConsistentRun.of(automaton, start)));
    }

    /** The component, with the automaton where it is one of several, and the line. */
    public String requirement() {
        return requirement;
    }

    /** The slice from which on the requirement promises nothing any more. */
    public OptionalInt satisfiedFrom() {
        return satisfiedFrom;
    }

    /** Why it cannot be said whether the requirement is kept. */
    public Optional<String> unknown() {
        return unknown;
    }

    private boolean isSettled() {
        return violated || unknown.isPresent();
    }

    /**
     * Judges what an event-driven component sends before the first event. Slices have no such
     * beginning: slice 0 shows it.
     */
    public Optional<Violation> begin(Letter shown) {
        return timed ? Optional.empty() : noted(keep(shown, instant));
    }

    /**
     * Judges a slice, or an event with what follows from it. After a violation nothing is judged
     * any more.
     *
     * @param shown what the outputs show in the slice; ports of others are ignored
     */
    public Optional<Violation> see(Letter letter, Letter shown) {
        Optional<Violation> found = Optional.empty();
        if (!isSettled()) {
            found = noted(judge(letter, shown));
        }
        number++;
        return found;
    }

    /**
     * Judges that a run ends in an error: only a requirement that may end in an error there as well
     * allows it, and it must have shown the same.
     *
     * @param end what was seen in spite of the error
     */
    public Optional<Violation> end(Trace.End end) {
        return isSettled() ? Optional.empty() : noted(judgeError(end));
    }

    /** Judges that a run ends in an error before its first slice or event. */
    public Violation endBefore() {
        violated = true;
        return violation(" forbids that the run begins with an error");
    }

    private Optional<Violation> noted(Optional<Violation> found) {
        violated |= found.isPresent();
        return found;
    }

    private Optional<Violation> judge(Letter letter, Letter shown) {
        Optional<Violation> found = ended().or(() -> keep(shown, late));
        if (found.isEmpty()) {
            noteChaos(!late.isEmpty());
            step(letter);
            if (unknown.isEmpty() && (!timed || !instant.isEmpty())) {
                found = ended().or(() -> keep(shown, instant));
                noteChaos(late.isEmpty());
            }
        }
        return found;
    }

    private Optional<Violation> judgeError(Trace.End end) {
        Optional<Violation> found = ended().or(() -> keep(end.shown(), late));
        if (found.isPresent()) {
            return found;
        }
        step(end.inputs());
        List<Integer> sent =
                instant.stream().filter(port -> !shown(end.shown(), port).isEmpty()).toList();
        boolean mayEnd = lost || !error.isEmpty();
        if (!sent.isEmpty() && mayEnd) {
            unknown = Optional.empty();
            String seen = new Accusation(outputs, ways).seen(sent, end.shown());
            return Optional.of(violation(" forbids " + seen + " in the slice of an error"));
        }
        if (!error.isEmpty()) {
            unknown = Optional.empty();
        } else if (lost) {
            unknown = Optional.of(tooMany());
        } else if (unknown.isEmpty()) {
            return Optional.of(violation(" forbids that the run ends in an error"));
        }
        return Optional.empty();
    }

    private List<Value> shown(Letter letter, int port) {
        return letter.messages(outputs.get(port).name());
    }

    /**
     * Where the component goes on, it has not ended in an error; the requirement may have had to.
     */
    private Optional<Violation> ended() {
        return ways.isEmpty() ? Optional.of(violation(error)) : Optional.empty();
    }

    private Violation violation(String text) {
        return new Violation(
                number, relation.automaton(), unit + number + ": " + requirement + text);
    }

    private Optional<Violation> keep(Letter shown, List<Integer> ports) {
        List<ConsistentRun> kept = ways.stream().filter(way -> agrees(way, shown, ports)).toList();
        if (kept.isEmpty()) {
            return Optional.of(violation(new Accusation(outputs, ways).of(ports, shown)));
        }
        ways = kept;
        return Optional.empty();
    }

    private boolean agrees(ConsistentRun way, Letter shown, List<Integer> ports) {
        for (int port : ports) {
            Sent promised = way.promised().ports().get(port);
            if (!promised.allows(shown(shown, port))) {
                return false;
            }
        }
        return true;
    }

    /**
     * @param seen whether what follows from the last step has been judged
     */
    private void noteChaos(boolean seen) {
        if (seen && satisfiedFrom.isEmpty() && ways.stream().anyMatch(ConsistentRun::isChaos)) {
            satisfiedFrom = OptionalInt.of(number);
        }
    }

    private void step(Letter letter) {
        WatchedInputs.Reading reading = inputs.read(letter);
        Set<Configuration> before = new LinkedHashSet<>();
        ways.forEach(way -> before.add(way.configuration()));
        error = "";
        switch (reading.kind()) {
            case LETTER -> follow(before, c -> relation.prospect(c, reading.input().orElseThrow()));
            case FOREIGN -> follow(before, this::unhandled);
            case NOTHING -> ways = ways.stream().map(this::withoutEvent).toList();
            case SEVERAL -> unknown = Optional.of("several events at once");
        }
    }

    private Prospect unhandled(Configuration before) {
        Reaction completion = relation.complete(before);
        return completion.next() == Configuration.ERROR
                ? new Prospect(List.of(), List.of(new RunError(completion.cause(), "")))
                : new Prospect(List.of(completion), List.of());
    }

    private ConsistentRun withoutEvent(ConsistentRun way) {
        Output nothing = new Output(Collections.nCopies(outputs.size(), Sent.SILENCE));
        return new ConsistentRun("there is no event", way.configuration(), nothing);
    }

    private void follow(Set<Configuration> before, Function<Configuration, Prospect> step) {
        List<ConsistentRun> next = new ArrayList<>();
        for (Configuration each : before) {
            Prospect prospect = step.apply(each);
            prospect.reactions()
                    .forEach(r -> next.add(ConsistentRun.of(relation.automaton(), each, r)));
            if (error.isEmpty() && !prospect.errors().isEmpty()) {
                error = only(each, prospect.errors().get(0));
            }
            if (next.size() > MOST_WAYS) {
                giveUp(next);
                return;
            }
        }
        ways = next;
    }

    private String only(Configuration before, RunError problem) {
        String text =
                problem.cause() instanceof Trace.Completed
                        ? "it forbids this input in " + state(before)
                        : "it goes wrong: " + problem.message();
        return " allows only an error in " + unit + number + ": " + text;
    }

    private String state(Configuration configuration) {
        return relation.automaton().states().get(configuration.state());
    }

    /** Where everything is allowed from here on, the other ways matter only for an error. */
    private void giveUp(List<ConsistentRun> next) {
        ways =
                Stream.concat(ways.stream(), next.stream())
                        .filter(ConsistentRun::isChaos)
                        .limit(1)
                        .toList();
        lost = true;
        if (ways.isEmpty()) {
            unknown = Optional.of(tooMany());
        }
    }

    private String tooMany() {
        return "more than " + MOST_WAYS + " ways to go on in " + unit + number;
    }

    /**
     * A requirement that a run does not keep.
     *
     * @param slice in which that is seen
     * @param message what was seen and what would have been allowed
     */
    public record Violation(int slice, Automaton requirement, String message) {}
}
