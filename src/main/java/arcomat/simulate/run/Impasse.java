package arcomat.simulate.run;

import arcomat.rt.ModelError;

/**
 * Ends a run that nothing in the model ends: automata that contradict each other leave no way to go
 * on, and what comes from outside may be no message of a port.
 */
final class Impasse extends ModelError {
    private static final long serialVersionUID = 1L;

    Impasse(String message) {
        super(message);
    }
}
