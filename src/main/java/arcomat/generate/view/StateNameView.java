package arcomat.generate.view;

/** A state: its named constant, its code and its name in the model. */
public record StateNameView(String constant, int code, String name) {}
