package arcomat.generate.view;

/** A field and the value that it gets. */
public record AssignmentView(String target, String value) {}
