package arcomat.editor.text;

import arcomat.source.SourceFile;
import arcomat.source.Span;

import org.eclipse.lsp4j.Position;
import org.eclipse.lsp4j.Range;

import java.net.URI;
import java.nio.file.FileSystemNotFoundException;
import java.nio.file.FileSystems;
import java.nio.file.Path;
import java.util.Optional;

/**
 * Between the places of the tool and those of the protocol. Both count UTF-16 units; the protocol
 * counts lines and columns from 0, the tool offsets.
 */
public final class Positions {
    private Positions() {}

    /** The file behind an address; nothing where it is no file, such as a document without name. */
    public static Optional<Path> path(String address) {
        try {
            return Optional.of(Path.of(URI.create(address)))
                    .filter(path -> path.getFileSystem() == FileSystems.getDefault())
                    .map(path -> path.toAbsolutePath().normalize());
        } catch (IllegalArgumentException | FileSystemNotFoundException noFile) {
            return Optional.empty();
        }
    }

    public static Position position(SourceFile file, int offset) {
        arcomat.source.Position place = file.position(offset);
        return new Position(place.line() - 1, place.column() - 1);
    }

    public static Range range(Span span) {
        return new Range(position(span.file(), span.start()), position(span.file(), span.end()));
    }

    /** From the beginning to the end of a text. */
    public static Range all(SourceFile file) {
        return range(file.span(0, file.text().length()));
    }

    /**
     * The offset of a position; one behind the end of its line is the end of the line, one behind
     * the last line the end of the text.
     */
    public static int offset(SourceFile file, Position position) {
        int above = Math.max(0, position.getLine());
        if (above >= file.lineCount()) {
            return file.text().length();
        }
        int line = above + 1;
        long offset = (long) file.lineStart(line) + Math.max(0, position.getCharacter());
        return (int) Math.min(offset, file.lineEnd(line));
    }

    public static Span span(SourceFile file, Range range) {
        int start = offset(file, range.getStart());
        return file.span(start, Math.max(start, offset(file, range.getEnd())));
    }
}
