package arcomat.generate.view;

/** A part of a condition that is too long for one method. */
public record ConditionView(String method, String condition) {}
