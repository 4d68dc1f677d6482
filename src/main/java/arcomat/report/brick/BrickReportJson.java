package arcomat.report.brick;

import arcomat.brick.BrickReport;
import arcomat.brick.api.BrickCost;
import arcomat.brick.need.Needs;
import arcomat.brick.need.Needs.Need;
import arcomat.report.finding.FindingsJson;
import arcomat.report.text.Json;
import arcomat.report.text.Printable;

import java.util.List;
import java.util.Optional;

/** For programs: whether a robot's jar fits, and how full the brick will be. */
public record BrickReportJson(
        boolean fits,
        List<FindingsJson.Finding> findings,
        List<Share> jar,
        Classes classes,
        Memory memory,
        Slice slice) {
    private static final long MILLISECOND = 1000;

    record Share(String origin, int classes, int methods, int bytes) {
        static Share of(BrickReport.Share share) {
            return new Share(
                    Printable.word(share.origin()),
                    share.classes(),
                    share.methods(),
                    share.bytes());
        }
    }

    record Classes(int number, boolean exact, int limit) {}

    record Memory(Optional<Long> bytes, boolean atMost, Optional<String> unknown, long limit) {}

    /** The limit is that of the longest slice, where slices take part in time at all. */
    record Slice(
            Optional<Long> microseconds,
            boolean atMost,
            Optional<String> unknown,
            Optional<Long> limit) {}

    public static String render(BrickReport report) {
        Needs needs = report.needs();
        Need memory = needs.memory();
        Need slice = needs.slice();
        return Json.text(
                new BrickReportJson(
                        report.fits(),
                        FindingsJson.Finding.all(report.findings()),
                        report.shares().stream().map(Share::of).toList(),
                        new Classes(needs.classes(), needs.isExact(), Needs.MOST_CLASSES),
                        new Memory(
                                amount(memory),
                                memory.isBound(),
                                memory.unknown(),
                                BrickCost.HEAP_BYTES),
                        new Slice(
                                amount(slice),
                                slice.isBound(),
                                slice.unknown(),
                                needs.cycle().stream()
                                        .mapToObj(cycle -> cycle * MILLISECOND)
                                        .findFirst())));
    }

    private static Optional<Long> amount(Need need) {
        return need.amount().stream().boxed().findFirst();
    }
}
