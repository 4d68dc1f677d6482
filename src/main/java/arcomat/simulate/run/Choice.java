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
     * The message on an output port that the model leaves open.
     *
     * @param required whether there has to be one
     */
    Optional<Value> message(Port port, boolean required);

    /**
     * Whether the first alternative is always picked. Then nobody looks for others, as in generated
     * code, and a guard behind an enabled one cannot divide by zero.
     */
    default boolean isTextOrder() {
        return false;
    }

    /** The first alternative in text order. */
    static Choice first() {
        return new FirstChoice();
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
        return new AskedChoice(asker);
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
