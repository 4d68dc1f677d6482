package arcomat.analysis.search.step;

import arcomat.analysis.search.Numbering;
import arcomat.semantics.expression.Output;
import arcomat.semantics.expression.Sent;

import org.jspecify.annotations.Nullable;

import java.util.Objects;

/**
 * Numbers for output cubes over the observed ports, and for the ends of runs. Both sides of a
 * comparison share them.
 */
public final class OutputCubes {
    /** No letter, but the run's end, which shows nothing: the distinguished error. */
    public static final int ERROR = 0;

    /**
     * @param cube null for the error that shows nothing
     * @param end whether the run ends here
     */
    private record Shown(@Nullable Output cube, boolean end) {}

    private final Numbering<Shown> numbers = new Numbering<>();

    public OutputCubes() {
        numbers.number(new Shown(null, true));
    }

    public int number(Output cube) {
        return numbers.number(new Shown(cube, false));
    }

    /** The end of a run, in a slice in which earlier reactions are still seen. */
    public int end(Output shown) {
        boolean nothing = shown.ports().stream().allMatch(Sent.SILENCE::equals);
        return nothing ? ERROR : numbers.number(new Shown(shown, true));
    }

    /** What is sent, or is still seen where the run ends; null for the error that shows nothing. */
    public @Nullable Output cube(int number) {
        return numbers.get(number).cube;
    }

    /** What is sent, where that is known not to be the error that shows nothing. */
    public Output letter(int number) {
        return Objects.requireNonNull(cube(number));
    }

    /** Whether it is a set of letters, and not the end of the run. */
    public boolean isLetter(int number) {
        return !numbers.get(number).end;
    }
}
