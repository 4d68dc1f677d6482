package arcomat.generate.plan;

/** How generated code chooses where a model leaves a choice. */
public enum Choosing {
    /** The first enabled transition in text order; no generator in the code. */
    FIRST,
    /** One draw of {@code arcomat.rt.Choice} per component, slice and real choice. */
    RANDOM
}
