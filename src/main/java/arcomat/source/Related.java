package arcomat.source;

/** Another place that explains a finding, with a note on what is to be seen there. */
public record Related(Span span, String note) {}
