package arcomat.brick.law;

import arcomat.brick.jar.RobotProgram;
import arcomat.brick.need.Needs;
import arcomat.source.Diagnostic;

import java.util.stream.Stream;

/**
 * ARC0911: a program has at most 256 classes, and 74 are there before the first of the robot's.
 * Beyond that the linker's scripts write a broken program and call it a success.
 */
final class ClassLimit extends Limit {
    /** One of the empty program's classes is its main class, and that is one of the robot's. */
    private static final int ROOM = Needs.MOST_CLASSES - (Needs.EMPTY_PROGRAM - 1);

    ClassLimit() {
        super("ARC0911", "classes", ROOM, "use fewer components, or spread them over two bricks");
    }

    @Override
    public Stream<Diagnostic> findings(RobotProgram program) {
        int own = program.files().size();
        if (isExceededBy(own)) {
            return Stream.of(excess(program.span(), "the robot", own));
        }
        Needs needs = program.needs();
        int linked = needs.classes();
        return needs.isExact() && linked > Needs.MOST_CLASSES
                ? Stream.of(excess(program.span(), "linked, the robot", linked, Needs.MOST_CLASSES))
                : Stream.empty();
    }
}
