package arcomat.fuzz.process;

import arcomat.fuzz.Dice;

/** A kind of input that somebody else may have made. */
interface Kind {
    String name();

    /** A damaged one, with calls that read it. */
    Input draw(Dice dice);
}
