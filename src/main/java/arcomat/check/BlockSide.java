package arcomat.check;

/** Which side of a slash a block stands on. */
enum BlockSide {
    /** Before the slash: what a transition reads. */
    INPUT,
    /** Behind the slash of a transition: what it sends and assigns. */
    OUTPUT,
    /** Behind the slash of an initial state. */
    INITIAL
}
