package arcomat.brick;

import arcomat.source.Diagnostic;

import java.util.stream.Stream;

/** ARC0912: a robot that comes near 256 classes may fail in the linker, which alone can count. */
final class ClassEstimate implements BrickLaw {
    private static final int NEAR_THE_LIMIT = 230;

    @Override
    public String code() {
        return "ARC0912";
    }

    @Override
    public Stream<Diagnostic> findings(Program program) {
        int about = LinkedClasses.about(program);
        return about <= NEAR_THE_LIMIT
                ? Stream.empty()
                : Stream.of(
                        Diagnostic.warning(
                                code(),
                                program.span(),
                                "linked, the robot has about %d classes, and the brick has room for %d; "
                                                .formatted(about, BrickReport.CLASSES)
                                        + "use fewer of leJOS' classes or fewer components"));
    }
}
