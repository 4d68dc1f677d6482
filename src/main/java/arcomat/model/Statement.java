package arcomat.model;

import java.util.List;
import java.util.stream.Stream;

/** A statement of an effect: what is done after the statement before it. */
public sealed interface Statement {
    /** Beyond it, it does not matter how many ways there are. */
    long MANY_WAYS = 1_000_000;

    /** Takes the sum apart: one answer for each form, and the compiler asks for all of them. */
    <R> R match(Cases<R> cases);

    /** How many ways there are through it, whatever its conditions are; many are a million. */
    default long ways() {
        return 1;
    }

    /** What is sent in it, whether or not it comes to that. */
    default List<Automaton.Send> sends() {
        return List.of();
    }

    /** The variables that are assigned in it, each once, in the order of the text. */
    default List<Variable> assigned() {
        return List.of();
    }

    /** All expressions in it. */
    List<Expression> expressions();

    /**
     * One answer for each form.
     *
     * @param <R> what is answered
     */
    interface Cases<R> {
        R sequence(Sequence sequence);

        R declare(Declare declare);

        R assign(Assign assign);

        R send(Send send);

        R choose(Choose choose);
    }

    /** One after the other; what is declared in it is known to its end. */
    record Sequence(List<Statement> statements) implements Statement {
        public Sequence {
            statements = List.copyOf(statements);
        }

        @Override
        public <R> R match(Cases<R> cases) {
            return cases.sequence(this);
        }

        @Override
        public List<Automaton.Send> sends() {
            return statements.stream().flatMap(each -> each.sends().stream()).toList();
        }

        @Override
        public List<Variable> assigned() {
            return statements.stream()
                    .flatMap(each -> each.assigned().stream())
                    .distinct()
                    .toList();
        }

        @Override
        public List<Expression> expressions() {
            return statements.stream().flatMap(each -> each.expressions().stream()).toList();
        }

        @Override
        public long ways() {
            long ways = 1;
            for (Statement each : statements) {
                ways = Math.min(MANY_WAYS, ways * each.ways());
            }
            return ways;
        }
    }

    /** A local name for a value, which is that of the variable in the beginning. */
    record Declare(Variable local) implements Statement {
        @Override
        public <R> R match(Cases<R> cases) {
            return cases.declare(this);
        }

        @Override
        public List<Expression> expressions() {
            return List.of(local.initial());
        }
    }

    /** A variable of the automaton, or a local one, gets a value. */
    record Assign(Variable variable, Expression value) implements Statement {
        @Override
        public <R> R match(Cases<R> cases) {
            return cases.assign(this);
        }

        @Override
        public List<Variable> assigned() {
            return List.of(variable);
        }

        @Override
        public List<Expression> expressions() {
            return List.of(value);
        }
    }

    /** What is sent last on a port is sent. */
    record Send(Automaton.Send send) implements Statement {
        @Override
        public <R> R match(Cases<R> cases) {
            return cases.send(this);
        }

        @Override
        public List<Automaton.Send> sends() {
            return List.of(send);
        }

        @Override
        public List<Expression> expressions() {
            return send.emission().values();
        }
    }

    /** One of two statements; one that is not there is an empty sequence. */
    record Choose(Expression condition, Statement then, Statement otherwise) implements Statement {
        @Override
        public <R> R match(Cases<R> cases) {
            return cases.choose(this);
        }

        @Override
        public List<Automaton.Send> sends() {
            return Stream.concat(then.sends().stream(), otherwise.sends().stream()).toList();
        }

        @Override
        public List<Variable> assigned() {
            return Stream.concat(then.assigned().stream(), otherwise.assigned().stream())
                    .distinct()
                    .toList();
        }

        @Override
        public List<Expression> expressions() {
            return Stream.of(
                            List.of(condition).stream(),
                            then.expressions().stream(),
                            otherwise.expressions().stream())
                    .flatMap(each -> each)
                    .toList();
        }

        @Override
        public long ways() {
            return Math.min(MANY_WAYS, then.ways() + otherwise.ways());
        }
    }
}
