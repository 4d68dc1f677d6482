package arcomat.guest;

import arcomat.source.SourceFile;
import arcomat.source.Span;

import java.util.ArrayList;
import java.util.List;

/** What came of models in another language: Arcomat's files, and findings in the originals. */
public final class Transcription {
    private final List<Written> files = new ArrayList<>();
    private final List<Finding> findings = new ArrayList<>();

    /**
     * A file to be written.
     *
     * @param original what it was made of
     */
    public record Written(SourceFile original, String path, String text) {}

    /**
     * Something about an original.
     *
     * @param hard whether something of it is missing in what was written
     */
    public record Finding(String code, boolean hard, Span place, String message) {}

    /**
     * Adds a file.
     *
     * @param path in the folder that is written, with forward slashes
     * @param text of a model, a class diagram or a stream test, in any layout
     */
    public Transcription write(SourceFile original, String path, String text) {
        files.add(new Written(original, path, text));
        return this;
    }

    /**
     * Says why something was not converted: an error.
     *
     * @param code of {@link Importer#codes}
     * @param message as those of the tool: it names the thing, says what to do, and begins with a
     *     small letter
     */
    public Transcription missing(String code, Span place, String message) {
        findings.add(new Finding(code, true, place, message));
        return this;
    }

    /** Says what somebody has to know of what was converted: a warning. */
    public Transcription note(String code, Span place, String message) {
        findings.add(new Finding(code, false, place, message));
        return this;
    }

    public List<Written> files() {
        return List.copyOf(files);
    }

    public List<Finding> findings() {
        return List.copyOf(findings);
    }
}
