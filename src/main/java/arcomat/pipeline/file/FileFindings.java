package arcomat.pipeline.file;

import arcomat.source.Diagnostic;
import arcomat.source.SourceFile;

import java.util.Set;

/** The findings about files that cannot be read as text. */
public final class FileFindings {
    /** Missing, forbidden, too large, or no file at all. */
    public static final String UNREADABLE = "ARC0002";

    static final String NOT_UTF8 = "ARC0003";
    static final String BINARY = "ARC0004";
    static final String LINK_LOOP = "ARC0007";

    private static final Set<String> CODES = Set.of(UNREADABLE, NOT_UTF8, BINARY, LINK_LOOP);

    private FileFindings() {}

    /** Whether a finding means that input could not be read. */
    public static boolean isUnreadableInput(Diagnostic finding) {
        return finding.isError() && CODES.contains(finding.code());
    }

    /**
     * An error about a file as a whole.
     *
     * @param path as the user knows it
     */
    public static Diagnostic error(String code, String path, String message) {
        return Diagnostic.error(code, new SourceFile(path, "").span(0, 0), message);
    }

    static Diagnostic warning(String code, String path, String message) {
        return Diagnostic.warning(code, new SourceFile(path, "").span(0, 0), message);
    }
}
