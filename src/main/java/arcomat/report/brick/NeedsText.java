package arcomat.report.brick;

import arcomat.brick.BrickReport;
import arcomat.brick.api.BrickCost;
import arcomat.brick.need.Need;
import arcomat.brick.need.Needs;

import java.util.Locale;

/** For people: how full the brick will be, a line for each of its limits. */
final class NeedsText {
    private static final double THOUSAND = 1000;

    private NeedsText() {}

    static String render(Needs needs) {
        return "linked with leJOS: %s%d of %d classes\n"
                        .formatted(
                                needs.isExact() ? "" : "about ",
                                needs.classes(),
                                BrickReport.CLASSES)
                + "memory: "
                + memory(needs.memory())
                + "\nlongest slice: "
                + slice(needs)
                + "\n";
    }

    private static String memory(Need memory) {
        return memory.amount().isPresent()
                ? String.format(
                        Locale.ROOT,
                        "about %.1f of %.1f kB",
                        memory.amount().getAsLong() / THOUSAND,
                        BrickCost.HEAP_BYTES / THOUSAND)
                : unknown(memory);
    }

    private static String slice(Needs needs) {
        Need slice = needs.slice();
        if (slice.amount().isEmpty()) {
            return unknown(slice);
        }
        String limit = needs.cycle().isPresent() ? " of " + needs.cycle().getAsInt() : "";
        double milliseconds = slice.amount().getAsLong() / THOUSAND;
        return String.format(Locale.ROOT, "about %.1f%s ms", milliseconds, limit);
    }

    private static String unknown(Need need) {
        return "not known: " + need.unknown().orElseThrow();
    }
}
