package arcomat.pipeline.beside;

import arcomat.source.Diagnostic;
import arcomat.source.SourceFile;
import arcomat.source.Span;

import java.nio.file.Path;
import java.util.List;
import java.util.Optional;

/** A text beside models: a world, a campaign, a script. */
public interface BesideText {
    /** What a command would find that reads it; less where that would take long. */
    List<Diagnostic> findings();

    /** What its words stand for, as far as that is written elsewhere. */
    List<Link> links();

    /**
     * The words of which one may stand at a place; none where it is a name, a number, or anything.
     */
    List<String> choices(int offset);

    /**
     * From a word to what it stands for.
     *
     * @param target empty for the whole file
     */
    record Link(Span from, Path file, Optional<Span> target) {}

    /** The text in front of the word at a place. */
    static SourceFile before(SourceFile text, int offset) {
        int start = offset;
        while (start > 0 && !Character.isWhitespace(text.text().charAt(start - 1))) {
            start--;
        }
        return new SourceFile(text.path(), text.text().substring(0, start));
    }
}
