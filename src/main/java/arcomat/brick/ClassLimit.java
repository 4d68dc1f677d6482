package arcomat.brick;

import arcomat.source.Diagnostic;

import java.util.stream.Stream;

/**
 * ARC0911: a program has at most 256 classes, and 75 are there before the first of the robot's.
 * Beyond that the linker's scripts write a broken program and call it a success.
 */
final class ClassLimit implements BrickLaw {
    private static final int ROOM = BrickReport.CLASSES - LinkedClasses.EMPTY_PROGRAM;

    @Override
    public String code() {
        return "ARC0911";
    }

    @Override
    public Stream<Diagnostic> findings(Program program) {
        int own = program.files().size();
        return own <= ROOM
                ? Stream.empty()
                : Stream.of(
                        Diagnostic.error(
                                code(),
                                program.span(),
                                Limit.message(
                                        "the robot",
                                        own,
                                        "classes",
                                        ROOM,
                                        "use fewer components, or spread them over two bricks")));
    }
}
