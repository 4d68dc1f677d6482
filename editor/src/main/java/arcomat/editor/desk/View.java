package arcomat.editor.desk;

import arcomat.editor.text.Positions;
import arcomat.guest.host.Guests;
import arcomat.pipeline.recheck.OpenModels;
import arcomat.source.Diagnostic;
import arcomat.source.SourceFile;
import arcomat.source.Span;
import arcomat.syntax.Parsed;

import org.eclipse.lsp4j.Location;
import org.eclipse.lsp4j.Position;

import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import java.util.function.Function;

/**
 * What a question is about: a file, among all that belong to it, as they are on the screen now.
 *
 * @param models of the file's model root
 * @param file the file
 * @param parsed what came of reading it
 * @param addresses where editors find the files of these models, by their paths
 */
public record View(
        OpenModels models, SourceFile file, Parsed parsed, Function<String, Path> addresses) {

    /** Who reads the file, where it is not in the tool's own language. */
    public Optional<Guests.Reader> reader() {
        return models.guests().reader(file.path());
    }

    /** Where editors find the file. */
    public Path place() {
        return addresses.apply(file.path());
    }

    /** What was found in the file by the last check. */
    public List<Diagnostic> findings() {
        return models.findings(file.path());
    }

    public int offset(Position position) {
        return Positions.offset(file, position);
    }

    /** A place in any file of these models. */
    public Location location(Span span) {
        return new Location(address(span.file().path()), Positions.range(span));
    }

    /** The address of a file of these models. */
    public String address(String path) {
        return addresses.apply(path).toUri().toString();
    }
}
