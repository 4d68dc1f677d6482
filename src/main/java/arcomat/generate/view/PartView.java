package arcomat.generate.view;

/** A part of a composite; {@code call} is empty where it has nothing to do in a slice. */
public record PartView(String type, String name, String arguments, String comment) {}
