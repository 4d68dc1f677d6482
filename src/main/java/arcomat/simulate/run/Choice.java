package arcomat.simulate.run;

import arcomat.model.Port;
import arcomat.model.Value;

import java.util.Optional;

/**
 * Decides where a model leaves something open while it runs. It is asked only where there is a real
 * choice, once per component and slice, in schedule order.
 *
 * <p>Where no transition is enabled, chaos, output and ignore all keep state and variables and send
 * nothing; a port that has to carry a message in every slice carries the first value of its type.
 * Only {@link #randomThroughout} draws those messages as well.
 */
public interface Choice {
    /**
     * Picks an alternative.
     *
     * @return its position, from 0
     */
    int pick(Question question);

    /**
     * The message on an output port that the model leaves open; where nobody draws one, the first
     * of its type where there has to be one.
     *
     * @param required whether there has to be one
     */
    default Optional<Value> message(Port port, boolean required) {
        return required ? Optional.of(port.type().first()) : Optional.empty();
    }

    /**
     * Whether the first alternative is always picked. Then nobody looks for others, as in generated
     * code, and a guard behind an enabled one cannot divide by zero.
     */
    default boolean isTextOrder() {
        return false;
    }

    /** The first alternative in text order. */
    static Choice first() {
        return new Choice() {
            @Override
            public boolean isTextOrder() {
                return true;
            }

            @Override
            public int pick(Question question) {
                return 0;
            }
        };
    }

    /** An alternative at random; the same seed always gives the same run, in compiled code too. */
    static Choice random(int seed) {
        return new RandomChoice(seed, false);
    }

    /** Like {@link #random}, and open messages are drawn too; compiled code has no such mode. */
    static Choice randomThroughout(int seed) {
        return new RandomChoice(seed, true);
    }

    /** What somebody answers. */
    static Choice ask(Asker asker) {
        return question -> {
            int answer = asker.ask(question);
            if (answer < 0 || answer >= question.count()) {
                throw new IllegalArgumentException(
                        "there are " + question.count() + " alternatives, " + answer + " is none");
            }
            return answer;
        };
    }

    /** Somebody who is asked, such as a user at a terminal. */
    @FunctionalInterface
    interface Asker {
        /**
         * Picks an alternative.
         *
         * @return its position, from 0
         */
        int ask(Question question);
    }
}
