package arcomat.analysis.engine;

import arcomat.semantics.Output;

/** Numbers for output cubes over the observed ports. Both sides of a comparison share them. */
public final class Outputs {
    /** No letter, but the run's end: the distinguished error. */
    public static final int ERROR = 0;

    private final Numbering<Output> cubes = new Numbering<>();

    public Outputs() {
        cubes.number(null);
    }

    int number(Output cube) {
        return cubes.number(cube);
    }

    public Output cube(int number) {
        return cubes.get(number);
    }

    /** Whether it is a set of letters, and not the end of the run. */
    public boolean isLetter(int number) {
        return number != ERROR;
    }
}
