package arcomat.analysis.search;

/**
 * A rule by which an analysis leaves work out. Each changes what an answer costs, none what it is;
 * but for the last two, which leave a remark out, and {@link #SYMBOLIC}, after which less is
 * remarked. A {@link Budget} is asked whenever one is about to be taken, so that a test sees that
 * it was, and asks again without it.
 */
public enum Shortcut {
    /**
     * Nothing can be forbidden where the right side may be in chaos and the left one cannot err.
     */
    CHAOS,

    /** What one configuration allows, a set with it in it does. */
    MET_ALONE,

    /** What a smaller set allows, a larger one does. */
    MET_SMALLER,

    /** Nothing can be forbidden where a member of the set simulates the left side. */
    SIMULATED,

    /** Where every set has one member, the pairs met are a simulation: none is looked for. */
    DETERMINED,

    /** Of the letters that a configuration does not tell apart, one is tried. */
    ALIKE,

    /** A network is searched by tables of its parts' steps, where none of them leaves much open. */
    PACKED,

    /** Parts that nothing depends on which is compared, and messages that nobody reads. */
    CONE,

    /** Variables that nobody reads are in no configuration of a network. */
    UNREAD_VARIABLES,

    /** Of configurations that differ in the places of equal parts, one is looked at. */
    EQUAL_PARTS,

    /** What an inductive invariant proves is not explored to the end. */
    SYMBOLIC,

    /** What conditions over variables show is not explored to the end. */
    CONDITIONS,

    /** Compositions refine each other if their parts do. */
    PART_BY_PART,

    /** How late a longer pipeline answers is not asked. */
    LONG_PIPELINE,

    /** How late an answer is, is not asked for longer than the answer is worth. */
    IMPATIENCE
}
