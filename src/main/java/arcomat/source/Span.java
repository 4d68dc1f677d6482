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

    /** Whether another one lies in it, in the file of the same path. */
    public boolean isAround(Span inner) {
        return file.path().equals(inner.file.path()) && start <= inner.start && inner.end <= end;
    }

    /** The part on its first line: what to point at where the whole would be too much. */
    public Span firstLine() {
        int line = startPosition().line();
        int lineEnd = file.lineStart(line) + file.line(line).length();
        return new Span(file, start, Math.max(start, Math.min(end, lineEnd)));
    }

    /**
     * As the record's own, which Java puts together when it is first asked: in a short check that
     * takes longer than all the comparisons.
     */
    @Override
    public boolean equals(Object other) {
        return other instanceof Span span
                && span.start == start
                && span.end == end
                && span.file.equals(file);
    }

    @Override
    public int hashCode() {
        return (31 * start + end) * 31 + file.hashCode();
    }

    /** {@code path:line:column}, as editors and terminals link it. */
    @Override
    public String toString() {
        return file.path() + ":" + startPosition();
    }
}
