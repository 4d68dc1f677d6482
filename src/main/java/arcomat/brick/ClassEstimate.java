package arcomat.brick;

import arcomat.brick.need.Needs;
import arcomat.source.Diagnostic;

import java.util.stream.Stream;

/** ARC0912: a robot that comes near 256 classes, or whose number is an estimate above that. */
final class ClassEstimate implements BrickLaw {
    @Override
    public String code() {
        return "ARC0912";
    }

    @Override
    public Stream<Diagnostic> findings(Program program) {
        Needs needs = program.needs();
        boolean isRefused = needs.isExact() && needs.classes() > BrickReport.CLASSES;
        return isRefused || needs.classes() <= Limit.NEARLY * BrickReport.CLASSES
                ? Stream.empty()
                : Stream.of(
                        Diagnostic.warning(
                                code(),
                                program.span(),
                                "linked, the robot has %s%d classes, and the brick has room for %d; "
                                                .formatted(
                                                        needs.isExact() ? "" : "about ",
                                                        needs.classes(),
                                                        BrickReport.CLASSES)
                                        + "use fewer of leJOS' classes or fewer components"));
    }
}
