package arcomat.brick;

import arcomat.brick.api.BrickCost;
import arcomat.brick.need.Need;
import arcomat.source.Diagnostic;

import java.util.Locale;
import java.util.stream.Stream;

/** ARC0917: the linked program lies in flash, but its objects and stacks need memory. */
final class MemoryLimit implements BrickLaw {
    private static final double KILOBYTE = 1000;
    private static final String ADVICE = "use fewer components, or spread them over two bricks";

    @Override
    public String code() {
        return "ARC0917";
    }

    @Override
    public Stream<Diagnostic> findings(Program program) {
        Need memory = program.needs().memory();
        if (memory.isAbove(BrickCost.HEAP_BYTES)) {
            String message =
                    "the robot needs about %.1f kB of memory, but the brick has %.1f kB; %s";
            return Stream.of(Diagnostic.error(code(), program.span(), formatted(message, memory)));
        }
        if (memory.isAbove(Limit.NEARLY * BrickCost.HEAP_BYTES)) {
            String message = "the robot needs about %.1f of the brick's %.1f kB of memory; %s";
            return Stream.of(
                    Diagnostic.warning(code(), program.span(), formatted(message, memory)));
        }
        return Stream.empty();
    }

    private static String formatted(String message, Need memory) {
        double bytes = memory.amount().orElseThrow();
        return String.format(
                Locale.ROOT, message, bytes / KILOBYTE, BrickCost.HEAP_BYTES / KILOBYTE, ADVICE);
    }
}
