package arcomat.brick;

import arcomat.brick.need.Needs;
import arcomat.source.Diagnostic;

import java.util.stream.Stream;

/**
 * ARC0911: a program has at most 256 classes, and 75 are there before the first of the robot's.
 * Beyond that the linker's scripts write a broken program and call it a success.
 */
final class ClassLimit implements BrickLaw {
    private static final int ROOM = BrickReport.CLASSES - Needs.EMPTY_PROGRAM;
    private static final String ADVICE = "use fewer components, or spread them over two bricks";

    @Override
    public String code() {
        return "ARC0911";
    }

    @Override
    public Stream<Diagnostic> findings(Program program) {
        int own = program.files().size();
        if (own > ROOM) {
            return finding(program, Limit.message("the robot", own, "classes", ROOM, ADVICE));
        }
        Needs needs = program.needs();
        return needs.isExact() && needs.classes() > BrickReport.CLASSES
                ? finding(
                        program,
                        Limit.message(
                                "linked, the robot",
                                needs.classes(),
                                "classes",
                                BrickReport.CLASSES,
                                ADVICE))
                : Stream.empty();
    }

    private Stream<Diagnostic> finding(Program program, String message) {
        return Stream.of(Diagnostic.error(code(), program.span(), message));
    }
}
