package arcomat.generate;

import arcomat.model.Component;

/** A state has more transitions that may be enabled together than a set in one number can hold. */
final class TooManyChoices extends RuntimeException {
    private static final long serialVersionUID = 1L;

    private final transient Component component;

    TooManyChoices(Component component, String state, int transitions) {
        super(
                "state "
                        + state
                        + " has "
                        + transitions
                        + " transitions that may be enabled together, and random choices are"
                        + " generated for at most 63; make their triggers exclude each other, or"
                        + " generate with --choose first");
        this.component = component;
    }

    Component component() {
        return component;
    }
}
