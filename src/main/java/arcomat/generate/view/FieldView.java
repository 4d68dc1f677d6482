package arcomat.generate.view;

/**
 * A parameter, variable or constant.
 *
 * @param initial its first value, empty for a parameter
 */
public record FieldView(String type, String name, String initial, String comment) {}
