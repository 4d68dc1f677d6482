package arcomat.source;

/** A finding that is declared in the text to be meant, and why. */
public record Suppressed(Diagnostic finding, String reason) {}
