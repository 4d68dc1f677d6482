package arcomat.report.finding;

import arcomat.report.text.Fields;
import arcomat.report.text.Printable;
import arcomat.source.Position;
import arcomat.source.Span;

import java.util.Optional;

/** Places as SARIF writes them; columns count UTF-16 units from 1, ends are exclusive. */
record SarifPlaces(SourceRoot root) {
    private static final String BASE = "%SRCROOT%";

    /** What relative URIs count from; where that is, nobody else needs to know. */
    static Fields bases() {
        Fields description = message("The folder that arcomat was started in.");
        return Fields.of(BASE, Fields.of("description", description));
    }

    Fields location(Span span) {
        // A file that cannot be read has no lines.
        Optional<Span> lines = Optional.of(span).filter(each -> !each.file().text().isEmpty());
        return Fields.of(
                "physicalLocation",
                Fields.of("artifactLocation", file(span))
                        .with("region", lines.map(SarifPlaces::region)));
    }

    /**
     * @param note what is to be seen there
     */
    Fields location(Span span, String note) {
        return location(span).with("message", message(note));
    }

    Fields file(Span span) {
        String path = span.file().path();
        boolean relative = SourceRoot.isRelative(root.relative(path));
        return Fields.of("uri", root.uri(path))
                .with("uriBaseId", Optional.of(BASE).filter(any -> relative));
    }

    static Fields region(Span span) {
        Position start = span.startPosition();
        Position end = span.endPosition();
        return Fields.of("startLine", start.line())
                .with("startColumn", start.column())
                .with("endLine", end.line())
                .with("endColumn", end.column());
    }

    /** Braces hold places for arguments in SARIF; those of models are doubled (section 3.11.5). */
    static Fields message(String text) {
        String safe = Printable.escapeKeepingLayout(text.strip());
        return Fields.of("text", safe.replace("{", "{{").replace("}", "}}"));
    }
}
