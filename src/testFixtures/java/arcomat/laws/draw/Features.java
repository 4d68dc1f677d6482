package arcomat.laws.draw;

import java.util.Arrays;
import java.util.EnumSet;
import java.util.Locale;
import java.util.Set;

/** What random models may contain. Fewer features find their faults sooner. */
public enum Features {
    /** Outputs with delay 0 and 1 in one component, and other delays on the other side. */
    MIXED_DELAYS,
    /** Several automata on one component. */
    SEVERAL_AUTOMATA,
    /** The event-driven profile, with lists of messages and latched ports. */
    EVENTS,
    /** Numbers without a range, texts, reals. */
    UNBOUNDED,
    /** Java's other number types, and characters. */
    NUMBER_TYPES,
    /** Ranges that may be left, divisions, completion error. */
    ERRORS,
    /** Components that are made of parts. */
    COMPOSITIONS,
    /** Messages and ports that an automaton leaves open. */
    OPEN,
    /** Variables of the component that its automaton writes. */
    FIELDS,
    /** Transitions that come before others. */
    RANKS,
    /** What is done one after the other, with choices. */
    STATEMENTS,
    /** What is computed in each slice, without states. */
    COMPUTED,
    /** Parts in one of several configurations. */
    VARIED,
    /** Conditions about each value of a set, and names for values. */
    QUANTIFIERS,
    /** Variables of which there are several of one name. */
    ARRAYS,
    /** Tables in the place of automata. */
    TABLES;

    /**
     * @param words names in any case with commas, each to be left out: {@code events,mixed_delays}
     */
    public static Set<Features> without(String words) {
        Set<Features> features = EnumSet.allOf(Features.class);
        Arrays.stream(words.split(","))
                .filter(word -> !word.isBlank())
                .forEach(word -> features.remove(valueOf(word.strip().toUpperCase(Locale.ROOT))));
        return features;
    }
}
