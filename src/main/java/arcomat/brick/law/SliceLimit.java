package arcomat.brick.law;

import arcomat.brick.jar.RobotProgram;
import arcomat.brick.need.Needs;
import arcomat.source.Diagnostic;

import java.util.stream.Stream;

/** ARC0918: a slice has to end before the next one is due. */
final class SliceLimit extends BrickLaw {
    private static final double MILLISECOND = 1000;
    private static final String ADVICE =
            "make the cycle longer, or let components of another brick do some of the work";

    SliceLimit() {
        super("ARC0918");
    }

    @Override
    public Stream<Diagnostic> findings(RobotProgram program) {
        Needs needs = program.needs();
        if (needs.cycle().isEmpty()) {
            return Stream.empty();
        }
        int cycle = needs.cycle().getAsInt();
        if (!needs.slice().isAbove(Limit.NEARLY * cycle * MILLISECOND)) {
            return Stream.empty();
        }
        double slice = needs.slice().amount().orElseThrow() / MILLISECOND;
        return Stream.of(
                needs.slice().isAbove(cycle * MILLISECOND)
                        ? error(
                                program.span(),
                                "a slice may take %.1f ms, but the next one is due after %d ms; %s",
                                slice,
                                cycle,
                                ADVICE)
                        : warning(
                                program.span(),
                                "a slice may take %.1f of the %d ms until the next one is due; %s",
                                slice,
                                cycle,
                                ADVICE));
    }
}
