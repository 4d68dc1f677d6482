package arcomat.pipeline.simulate;

import arcomat.generate.plan.Choosing;
import arcomat.model.Letter;
import arcomat.simulate.run.Choice;

import java.util.Optional;

/** Who decides where a model that runs leaves something open. */
public sealed interface Decider {
    /** What remarks on a run call it, in letters of whatever case. */
    String name();

    /** For the interpreter. */
    Choice choice(int seed);

    /** For compiled code; empty where code cannot do so. */
    Optional<Choosing> compiled();

    /** Told before each step, so that questions about it can be understood. */
    default void stepBegins(int number, Letter inputs) {}

    /** Nobody has to be asked. */
    enum Rule implements Decider {
        /** The first alternative in text order. */
        FIRST,
        /** What is drawn with the seed. */
        RANDOM;

        @Override
        public Choice choice(int seed) {
            return this == FIRST ? Choice.first() : Choice.random(seed);
        }

        @Override
        public Optional<Choosing> compiled() {
            return Optional.of(this == FIRST ? Choosing.FIRST : Choosing.RANDOM);
        }
    }

    /** Somebody at a terminal. */
    non-sealed interface Dialogue extends Decider, Choice.Asker {
        @Override
        default String name() {
            return "ask";
        }

        @Override
        default Choice choice(int seed) {
            return Choice.ask(this);
        }

        @Override
        default Optional<Choosing> compiled() {
            return Optional.empty();
        }
    }
}
