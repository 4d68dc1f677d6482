package arcomat.analysis.game;

import arcomat.analysis.search.step.OutputCubes;
import arcomat.analysis.search.step.Steps;

import java.util.Arrays;
import java.util.List;

/**
 * What one requirement allows after one kind of letter: its steps, sorted by what they send.
 *
 * @param number the same for replies that allow the same and lead to the same
 * @param before per member of the set: the configuration, and where its steps begin in {@code all}
 * @param cubes numbers of the distinct output cubes, in text order
 * @param list the number of these cubes as a list
 * @param next per cube the configurations afterwards
 */
record Reply(int number, List<Part> before, int[] cubes, int list, int[][] next) {

    /** Whether the run may end here, in an error. */
    boolean mayEnd() {
        return Arrays.stream(cubes).anyMatch(cube -> cube == OutputCubes.ERROR);
    }

    /** The steps of one member of the set. */
    record Part(int configuration, Steps steps) {}
}
