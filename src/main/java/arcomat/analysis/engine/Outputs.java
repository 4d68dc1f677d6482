package arcomat.analysis.engine;

import arcomat.semantics.Output;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;

/** Numbers for output cubes over the observed ports. Both sides of a comparison share them. */
public final class Outputs {
    /** No letter, but the run's end: the distinguished error. */
    public static final int ERROR = 0;

    private final Map<Output, Integer> numbers = new HashMap<>();
    private final List<Output> cubes = new ArrayList<>();

    public Outputs() {
        cubes.add(null);
    }

    int number(Output cube) {
        Integer known = numbers.get(cube);
        if (known == null) {
            known = cubes.size();
            numbers.put(cube, known);
            cubes.add(cube);
        }
        return known;
    }

    public Output cube(int number) {
        return cubes.get(number);
    }

    /** Whether it is a set of letters, and not the end of the run. */
    public boolean isLetter(int number) {
        return number != ERROR;
    }
}
