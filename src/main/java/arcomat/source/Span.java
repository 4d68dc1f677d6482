package arcomat.source;

/** The half-open range {@code [start, end)} of offsets in a file. */
public record Span(SourceFile file, int start, int end) {
    public Position startPosition() {
        return file.position(start);
    }

    public Position endPosition() {
        return file.position(end);
    }

    public String text() {
        return file.text().substring(start, end);
    }

    /** From the start of this span to the end of another in the same file. */
    public Span to(Span last) {
        return new Span(file, start, last.end);
    }

    /** {@code path:line:column}, as editors and terminals link it. */
    @Override
    public String toString() {
        return file.path() + ":" + startPosition();
    }
}
