package arcomat.analysis.search.system;

import arcomat.analysis.search.letter.LetterClasses;
import arcomat.analysis.search.step.Steps;
import arcomat.analysis.smt.DataStep;
import arcomat.model.Component;
import arcomat.model.Port;
import arcomat.model.Trace;
import arcomat.model.Value;
import arcomat.semantics.expression.DataSorts;

import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;

/**
 * A labelled transition system, given by its successor function: one side of a comparison. Its
 * configurations are numbered as they are met, and its steps are remembered. Not for several
 * threads.
 */
public interface TransitionSystem {
    /** Whether a letter is a slice or an event. */
    Component.Profile profile();

    /** The ports that a letter for {@link #steps} has messages for, by position. */
    List<Port> inputs();

    /** All output ports, as {@link Steps#whole} lists them. */
    List<Port> outputs();

    /**
     * Per compared port the number of slices after which a reaction is seen there, 0 or 1; -1 where
     * nothing is ever sent, and with events, which have no slices.
     */
    int[] delays();

    /**
     * Output ports that carry the very message of a compared one, by name: they are on one wire.
     */
    default Map<String, String> twins() {
        return Map.of();
    }

    /** The beginnings: what is sent before anything is read, and the configurations then. */
    Steps openings();

    /** The letters that a configuration tells apart. */
    LetterClasses letterClasses(int configuration);

    /**
     * The steps that may be possible in a configuration, told as expressions over the messages;
     * empty where that cannot be told.
     */
    default Optional<List<DataStep>> dataSteps(int configuration) {
        return Optional.empty();
    }

    /**
     * @param kind of the letter, as the configuration's letter classes say
     */
    Steps steps(int configuration, long kind, Value[] letter);

    /** The steps with a letter of whichever kind. */
    default Steps steps(int configuration, Value[] letter) {
        return steps(configuration, letterClasses(configuration).kind(letter), letter);
    }

    /** Whether any output may be sent from here on; that a run ends in an error is not allowed. */
    boolean isChaos(int configuration);

    /**
     * Whether some configuration that was met stands for several: what it has sent is left open
     * until it is read or seen, a slice later.
     */
    boolean postpones();

    /** Whether some run may end in an error; says yes where that is not sure. */
    boolean mayErr();

    /** The configuration in words: the names of its states, values of its variables. */
    String describe(int configuration);

    /** An unambiguous name of a configuration, the same in every run. */
    String name(int configuration);

    /** What made the steps that a search has needed. */
    Set<Trace.Cause> used();

    /**
     * Why some of the steps that have been asked for are left out; those that are there, are
     * possible. Empty where none is left out.
     */
    default Optional<String> leftOut() {
        return Optional.empty();
    }

    /** Tells how its data flow, and returns where they are. */
    DataPlaces data(DataSorts sorts);

    /** How many configurations have been met. */
    int size();
}
