package arcomat.pipeline.brick;

import arcomat.brick.BrickReport;

import java.util.List;
import java.util.Optional;
import java.util.OptionalInt;

/**
 * What came of linking.
 *
 * @param report about the jar; a jar that does not fit is not linked
 * @param linked the program; empty if there is none
 * @param failure why the linker gave none
 * @param output what the linker said, where it failed: all of it, if that is little
 * @param log the file with all of it, as shown, where it is much
 */
public record LinkResult(
        BrickReport report,
        Optional<Linked> linked,
        Optional<String> failure,
        List<String> output,
        Optional<String> log) {
    /** Of a jar that does not fit. */
    static LinkResult refused(BrickReport report) {
        return new LinkResult(
                report, Optional.empty(), Optional.empty(), List.of(), Optional.empty());
    }

    static LinkResult of(BrickReport report, Linked linked) {
        return new LinkResult(
                report, Optional.of(linked), Optional.empty(), List.of(), Optional.empty());
    }

    static LinkResult failed(
            BrickReport report, String failure, List<String> output, Optional<String> log) {
        return new LinkResult(report, Optional.empty(), Optional.of(failure), output, log);
    }

    public LinkResult {
        output = List.copyOf(output);
    }

    /**
     * A program for the brick.
     *
     * @param path as shown
     * @param bytes size of the file
     * @param classes as the linker counts them; empty if it did not say
     */
    public record Linked(String path, long bytes, OptionalInt classes) {}
}
