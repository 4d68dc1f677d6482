package arcomat.brick;

import arcomat.brick.need.Need;
import arcomat.brick.need.Needs;
import arcomat.source.Diagnostic;

import java.util.Locale;
import java.util.stream.Stream;

/** ARC0918: a slice has to end before the next one is due. */
final class SliceLimit implements BrickLaw {
    private static final double MILLISECOND = 1000;
    private static final String ADVICE =
            "make the cycle longer, or let components of another brick do some of the work";

    @Override
    public String code() {
        return "ARC0918";
    }

    @Override
    public Stream<Diagnostic> findings(Program program) {
        Needs needs = program.needs();
        if (needs.cycle().isEmpty()) {
            return Stream.empty();
        }
        int cycle = needs.cycle().getAsInt();
        if (needs.slice().isAbove(cycle * MILLISECOND)) {
            String message = "a slice may take %.1f ms, but the next one is due after %d ms; %s";
            return Stream.of(
                    Diagnostic.error(code(), program.span(), formatted(message, needs, cycle)));
        }
        if (needs.slice().isAbove(Limit.NEARLY * cycle * MILLISECOND)) {
            String message = "a slice may take %.1f of the %d ms until the next one is due; %s";
            return Stream.of(
                    Diagnostic.warning(code(), program.span(), formatted(message, needs, cycle)));
        }
        return Stream.empty();
    }

    private static String formatted(String message, Needs needs, int cycle) {
        Need slice = needs.slice();
        double microseconds = slice.amount().orElseThrow();
        return String.format(Locale.ROOT, message, microseconds / MILLISECOND, cycle, ADVICE);
    }
}
