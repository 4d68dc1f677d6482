package arcomat.editor.answer;

import arcomat.editor.answer.completion.LineCompletion;
import arcomat.editor.desk.Desk;
import arcomat.editor.text.Positions;
import arcomat.pipeline.beside.BesideText;
import arcomat.source.SourceFile;

import org.eclipse.lsp4j.CompletionItem;
import org.eclipse.lsp4j.Location;
import org.eclipse.lsp4j.Position;
import org.eclipse.lsp4j.Range;
import org.eclipse.lsp4j.TextDocumentIdentifier;

import java.util.List;
import java.util.Optional;

/**
 * Answers about a world, a campaign or a script.
 *
 * @param file as it is on the screen
 */
public record BesideModels(BesideText text, SourceFile file) {
    private static final Range BEGINNING = new Range(new Position(0, 0), new Position(0, 0));

    /** Nothing where a document is something else. */
    public static Optional<BesideModels> on(Desk desk, TextDocumentIdentifier document) {
        return Positions.path(document.getUri())
                .flatMap(
                        path ->
                                desk.beside(path)
                                        .flatMap(
                                                text ->
                                                        desk.onScreen(path)
                                                                .map(
                                                                        file ->
                                                                                new BesideModels(
                                                                                        text,
                                                                                        file))));
    }

    /** What the word under the cursor stands for. */
    public List<Location> definition(Position position) {
        int offset = Positions.offset(file, position);
        return text.links().stream()
                .filter(link -> link.from().start() <= offset && offset <= link.from().end())
                .map(BesideModels::location)
                .toList();
    }

    private static Location location(BesideText.Link link) {
        return new Location(
                link.file().toUri().toString(),
                link.target().map(Positions::range).orElse(BEGINNING));
    }

    /** What may be written at the cursor. */
    public List<CompletionItem> completion(Position position) {
        return LineCompletion.at(text, file, Positions.offset(file, position));
    }
}
