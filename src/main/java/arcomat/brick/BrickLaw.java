package arcomat.brick;

import arcomat.source.Diagnostic;

import java.util.stream.Stream;

/** Something that has to hold of a program for the brick. */
interface BrickLaw {
    /** The code of its findings, unique, with a page that explains it. */
    String code();

    /** Where the program breaks the law, in any order. */
    Stream<Diagnostic> findings(Program program);
}
