package arcomat.source;

/** Replaces the text of a span. */
public record TextEdit(Span span, String text) {}
