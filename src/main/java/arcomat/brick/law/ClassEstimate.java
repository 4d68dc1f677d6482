package arcomat.brick.law;

import arcomat.brick.jar.RobotProgram;
import arcomat.brick.need.Needs;
import arcomat.source.Diagnostic;

import java.util.stream.Stream;

/** ARC0912: a robot that comes near 256 classes, or whose number is an estimate above that. */
final class ClassEstimate extends BrickLaw {
    ClassEstimate() {
        super("ARC0912");
    }

    @Override
    public Stream<Diagnostic> findings(RobotProgram program) {
        Needs needs = program.needs();
        boolean isRefused = needs.isExact() && needs.classes() > Needs.MOST_CLASSES;
        return isRefused || needs.classes() <= Limit.NEARLY * Needs.MOST_CLASSES
                ? Stream.empty()
                : Stream.of(
                        warning(
                                program.span(),
                                "linked, the robot has %s%d classes, and the brick has room for %d;"
                                        + " use fewer of leJOS' classes or fewer components",
                                needs.isExact() ? "" : "about ",
                                needs.classes(),
                                Needs.MOST_CLASSES));
    }
}
