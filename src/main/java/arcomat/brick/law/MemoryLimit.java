package arcomat.brick.law;

import arcomat.brick.api.BrickCost;
import arcomat.brick.jar.RobotProgram;
import arcomat.brick.need.Needs.Need;
import arcomat.source.Diagnostic;

import java.util.stream.Stream;

/** ARC0917: the linked program lies in flash, but its objects and stacks need memory. */
final class MemoryLimit extends BrickLaw {
    private static final double KILOBYTE = 1000;
    private static final String ADVICE = "use fewer components, or spread them over two bricks";

    MemoryLimit() {
        super("ARC0917");
    }

    @Override
    public Stream<Diagnostic> findings(RobotProgram program) {
        Need memory = program.needs().memory();
        if (!memory.isAbove(Limit.NEARLY * BrickCost.HEAP_BYTES)) {
            return Stream.empty();
        }
        double needed = memory.amount().orElseThrow() / KILOBYTE;
        double room = BrickCost.HEAP_BYTES / KILOBYTE;
        return Stream.of(
                memory.isAbove(BrickCost.HEAP_BYTES)
                        ? error(
                                program.span(),
                                "the robot needs about %.1f kB of memory, but the brick has %.1f"
                                        + " kB; %s",
                                needed,
                                room,
                                ADVICE)
                        : warning(
                                program.span(),
                                "the robot needs about %.1f of the brick's %.1f kB of memory; %s",
                                needed,
                                room,
                                ADVICE));
    }
}
