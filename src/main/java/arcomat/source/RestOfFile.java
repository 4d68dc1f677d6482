package arcomat.source;

import java.util.Collection;
import java.util.List;
import java.util.Locale;

/**
 * Warns that a file may have more errors than are told, so that no sum of them is mistaken for all:
 * it has too many, or one that keeps the file from being parsed.
 */
public final class RestOfFile {
    private static final String CODE = "ARC0008";

    private RestOfFile() {}

    /**
     * A finding of its own, so that it arrives wherever findings do.
     *
     * @param next the first error that is not told
     * @param told how many were told before it
     */
    public static Diagnostic from(Span next, int told) {
        return Diagnostic.warning(
                CODE,
                next,
                String.format(
                        Locale.ROOT,
                        "There are more errors from here on. %d are shown; the syntax of the rest"
                                + " of this file was not looked at. Mend them and check again.",
                        told));
    }

    /**
     * That a file is not parsed.
     *
     * @param obstacle the last error that keeps it from being parsed
     */
    public static Diagnostic unread(Span obstacle) {
        return Diagnostic.warning(
                CODE,
                obstacle,
                "The syntax of the rest of this file was not looked at. Mend this and check"
                        + " again.");
    }

    /** The files that some finding says this of, in the order of the findings. */
    public static List<String> files(Collection<Diagnostic> findings) {
        return findings.stream()
                .filter(each -> each.code().equals(CODE))
                .map(each -> each.span().file().path())
                .distinct()
                .toList();
    }
}
