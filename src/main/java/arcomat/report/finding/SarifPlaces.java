package arcomat.report.finding;

import arcomat.report.text.Printable;
import arcomat.source.Position;
import arcomat.source.Related;
import arcomat.source.Span;

import java.util.Map;
import java.util.Optional;

/** Places as SARIF writes them; columns count UTF-16 units from 1, ends are exclusive. */
record SarifPlaces(SourceRoot root) {
    private static final String BASE = "%SRCROOT%";

    /**
     * A place.
     *
     * @param message what is to be seen there
     */
    record Location(Optional<Integer> id, Physical physicalLocation, Optional<Message> message) {}

    record Physical(File artifactLocation, Optional<Region> region) {}

    record File(String uri, Optional<String> uriBaseId) {}

    record Region(int startLine, int startColumn, int endLine, int endColumn) {
        static Region of(Span span) {
            Position start = span.startPosition();
            Position end = span.endPosition();
            return new Region(start.line(), start.column(), end.line(), end.column());
        }
    }

    record Message(String text) {}

    /** What relative URIs count from; where that is, nobody else needs to know. */
    static Map<String, ?> bases() {
        Message description = message("The folder that arcomat was started in.");
        return Map.of(BASE, Map.of("description", description));
    }

    Location location(Span span) {
        return new Location(Optional.empty(), physical(span), Optional.empty());
    }

    Location location(Span span, String note) {
        return new Location(Optional.empty(), physical(span), Optional.of(message(note)));
    }

    Location related(int id, Related related) {
        return new Location(
                Optional.of(id), physical(related.span()), Optional.of(message(related.note())));
    }

    /** A file that cannot be read has no lines. */
    private Physical physical(Span span) {
        return new Physical(
                file(span),
                Optional.of(span).filter(s -> !s.file().text().isEmpty()).map(Region::of));
    }

    File file(Span span) {
        String path = span.file().path();
        boolean relative = SourceRoot.isRelative(root.relative(path));
        return new File(root.uri(path), Optional.of(BASE).filter(any -> relative));
    }

    /** Braces hold places for arguments in SARIF; those of models are doubled (section 3.11.5). */
    static Message message(String text) {
        String safe = Printable.escapeKeepingLayout(text.strip());
        return new Message(safe.replace("{", "{{").replace("}", "}}"));
    }
}
