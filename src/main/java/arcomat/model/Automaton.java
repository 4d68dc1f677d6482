package arcomat.model;

import arcomat.source.Span;

import java.util.Collections;
import java.util.List;
import java.util.Optional;
import java.util.function.Function;
import java.util.function.Supplier;

/**
 * An I/O-omega automaton over the ports of its component.
 *
 * @param name empty for an automaton without a name
 * @param states names in the order of their declaration; states are known by their index
 * @param violated what a robot does that watches itself for it
 * @param initials alternatives
 * @param places where each state is declared, by its index
 * @param within names of what each state stands in, from the outermost on, by its index: for
 *     whoever looks at it, since what it means is said without
 */
public record Automaton(
        String name,
        Completion completion,
        Omitted omitted,
        Violated violated,
        List<String> states,
        List<Variable> variables,
        List<Initial> initials,
        List<Transition> transitions,
        List<Span> places,
        List<List<String>> within,
        Span span) {
    public Automaton {
        states = List.copyOf(states);
        variables = List.copyOf(variables);
        initials = List.copyOf(initials);
        transitions = List.copyOf(transitions);
        places = List.copyOf(places);
        within = within.stream().map(List::copyOf).toList();
    }

    /** Where all states are declared in one place. */
    public Automaton(
            String name,
            Completion completion,
            Omitted omitted,
            List<String> states,
            List<Variable> variables,
            List<Initial> initials,
            List<Transition> transitions,
            Span span) {
        this(
                name,
                completion,
                omitted,
                Violated.STOP,
                states,
                variables,
                initials,
                transitions,
                Collections.nCopies(states.size(), span),
                Collections.nCopies(states.size(), List.of()),
                span);
    }

    /** Where a transition leads: {@code driving -> waiting}. */
    public String arrow(Transition transition) {
        return states.get(transition.source) + " -> " + states.get(transition.target);
    }

    /** Those that come first: the transition is not taken where one of them could be. */
    public List<Transition> before(Transition transition) {
        return transition.rank == 0
                ? List.of()
                : transitions.stream()
                        .filter(each -> each.source == transition.source)
                        .filter(each -> each.rank < transition.rank)
                        .toList();
    }

    /** The same with states that stand in others. */
    public Automaton within(List<List<String>> names) {
        return new Automaton(
                name,
                completion,
                omitted,
                violated,
                states,
                variables,
                initials,
                transitions,
                places,
                names,
                span);
    }

    /** The same with another completion. */
    public Automaton with(Completion other) {
        return with(other, initials, transitions);
    }

    /** The same with other transitions between its states. */
    public Automaton withTransitions(List<Transition> others) {
        return with(completion, initials, others);
    }

    /** The same with another beginning. */
    public Automaton withInitials(List<Initial> others) {
        return with(completion, others, transitions);
    }

    /** The same where a robot that watches itself does something else at a violation. */
    public Automaton with(Violated other) {
        return new Automaton(
                name,
                completion,
                omitted,
                other,
                states,
                variables,
                initials,
                transitions,
                places,
                within,
                span);
    }

    private Automaton with(Completion end, List<Initial> begin, List<Transition> steps) {
        return new Automaton(
                name, end, omitted, violated, states, variables, begin, steps, places, within,
                span);
    }

    /** What happens where no transition is enabled. */
    public enum Completion {
        /** Any output, and anything from then on. */
        CHAOS,
        /** Any output; state and variables kept. */
        OUTPUT,
        /** No output; state and variables kept. */
        IGNORE,
        /** A distinguished error, for good. */
        ERROR
    }

    /** What a port does that an output block does not mention. */
    public enum Omitted {
        SILENT,
        FREE
    }

    /** What a robot does when it sees that it does not keep a requirement. */
    public enum Violated {
        /** Its motors stand, and its program ends. */
        STOP,
        /** It says so, and goes on. */
        CONTINUE
    }

    /** An initial state with what is sent and assigned before anything is read. */
    public record Initial(int state, List<Send> sends, List<Assignment> assignments, Span span) {
        public Initial {
            sends = List.copyOf(sends);
            assignments = List.copyOf(assignments);
        }
    }

    /**
     * Matches, guard, sends and assignments read the configuration before the step.
     *
     * @param rank it may be taken only where none out of the same state with a smaller one could be
     * @param body the statements that it is a way through, where statements choose
     */
    public record Transition(
            int source,
            int target,
            Optional<Expression> guard,
            List<Match> matches,
            List<Send> sends,
            List<Assignment> assignments,
            int rank,
            Optional<Body> body,
            Span span) {
        public Transition {
            matches = List.copyOf(matches);
            sends = List.copyOf(sends);
            assignments = List.copyOf(assignments);
        }

        /** Without statements. */
        public Transition(
                int source,
                int target,
                Optional<Expression> guard,
                List<Match> matches,
                List<Send> sends,
                List<Assignment> assignments,
                int rank,
                Span span) {
            this(source, target, guard, matches, sends, assignments, rank, Optional.empty(), span);
        }

        /** Among the first ones. */
        public Transition(
                int source,
                int target,
                Optional<Expression> guard,
                List<Match> matches,
                List<Send> sends,
                List<Assignment> assignments,
                Span span) {
            this(source, target, guard, matches, sends, assignments, 0, span);
        }

        /** The same between other states. */
        public Transition between(int otherSource, int otherTarget) {
            return new Transition(
                    otherSource, otherTarget, guard, matches, sends, assignments, rank, span);
        }

        /** The same between its states, when something else is asked, with another effect. */
        public Transition with(
                Optional<Expression> otherGuard,
                List<Match> otherMatches,
                List<Send> otherSends,
                List<Assignment> otherAssignments) {
            return new Transition(
                    source,
                    target,
                    otherGuard,
                    otherMatches,
                    otherSends,
                    otherAssignments,
                    rank,
                    span);
        }

        /** Whether what it does is said by statements alone; it sends and assigns nothing else. */
        public boolean isWhole() {
            return body.filter(each -> each.standing() == Standing.WHOLE).isPresent();
        }

        /** Whether it stands for the same statements as another one. */
        public boolean isSameStatements(Transition other) {
            return body.isPresent() && other.body.isPresent() && body.get() == other.body.get();
        }

        /** The same as one that stands for statements. */
        public Transition of(Body statements) {
            return new Transition(
                    source,
                    target,
                    guard,
                    matches,
                    sends,
                    assignments,
                    rank,
                    Optional.of(statements),
                    span);
        }

        public Transition withRank(int otherRank) {
            return new Transition(
                    source, target, guard, matches, sends, assignments, otherRank, span);
        }
    }

    /**
     * Statements as they are written. The transitions that stand for them say the same and follow
     * each other; whoever changes one of them says something else, and leaves it out.
     *
     * @param guard what is asked besides what the statements ask
     * @param statement what is done
     * @param transitions how many stand for it
     */
    public record Body(
            Optional<Expression> guard,
            List<Match> matches,
            Statement statement,
            int transitions,
            Standing standing) {
        public Body {
            matches = List.copyOf(matches);
        }

        /** Whether it has one transition for each way, numbered by the choices on the way. */
        public boolean isNumbered() {
            return standing == Standing.WAYS && statement.ways() == transitions;
        }
    }

    /** How transitions stand for statements. */
    public enum Standing {
        /** Each for a way that may be gone, those by the first branch of a choice before others. */
        WAYS,
        /** Each for ways that send on the same ports; values say which of them is gone. */
        JOINED,
        /** One for all ways: what it sends and assigns is said by its statements alone. */
        WHOLE
    }

    /**
     * What the input block asks of one port; a port without a match may carry anything or nothing.
     */
    public record Match(Port port, Pattern pattern) {}

    /** What is asked of a port. */
    public sealed interface Pattern {
        /** Takes the sum apart: one answer for each form, and the compiler asks for all of them. */
        <R> R match(Function<OneOf, R> oneOf, Supplier<R> absent, Supplier<R> present);

        /** What a message is compared with. */
        default List<Expression> values() {
            return List.of();
        }
    }

    /** Present, and equal to one of the values. */
    public record OneOf(List<Expression> values) implements Pattern {
        public OneOf {
            values = List.copyOf(values);
        }

        @Override
        public <R> R match(Function<OneOf, R> oneOf, Supplier<R> absent, Supplier<R> present) {
            return oneOf.apply(this);
        }
    }

    /** {@code --}: no message. */
    public record Absent() implements Pattern {
        @Override
        public <R> R match(Function<OneOf, R> oneOf, Supplier<R> absent, Supplier<R> present) {
            return absent.get();
        }
    }

    /** {@code ?}: some message. */
    public record Present() implements Pattern {
        @Override
        public <R> R match(Function<OneOf, R> oneOf, Supplier<R> absent, Supplier<R> present) {
            return present.get();
        }
    }

    /** What the output block says about one port. */
    public record Send(Port port, Emission emission) {}

    /** What is sent on a port. */
    public sealed interface Emission {
        /** Takes the sum apart: one answer for each form, and the compiler asks for all of them. */
        <R> R match(Function<Messages, R> messages, Supplier<R> silence, Supplier<R> any);

        /** What is computed to be sent. */
        default List<Expression> values() {
            return List.of();
        }
    }

    /** One message; in the event-driven profile one or more, in order. */
    public record Messages(List<Expression> values) implements Emission {
        public Messages {
            values = List.copyOf(values);
        }

        @Override
        public <R> R match(Function<Messages, R> messages, Supplier<R> silence, Supplier<R> any) {
            return messages.apply(this);
        }
    }

    /** {@code --}: nothing is sent. */
    public record Silence() implements Emission {
        @Override
        public <R> R match(Function<Messages, R> messages, Supplier<R> silence, Supplier<R> any) {
            return silence.get();
        }
    }

    /** {@code ?}: some message, left open. */
    public record AnyMessage() implements Emission {
        @Override
        public <R> R match(Function<Messages, R> messages, Supplier<R> silence, Supplier<R> any) {
            return any.get();
        }
    }

    public record Assignment(Variable variable, Expression value) {}
}
