package arcomat.simulate.run;

import java.util.List;
import java.util.function.IntFunction;
import java.util.stream.IntStream;

/**
 * A real choice in a run.
 *
 * @param instance path of the instance, empty for the component that runs
 * @param step number of the slice or event
 * @param count how many alternatives there are, at least 2
 * @param description says what an alternative is, by its position
 */
public record Question(String instance, int step, int count, IntFunction<String> description) {
    /** What each alternative is, such as {@code driving -> waiting / cmd = stop}. */
    public List<String> alternatives() {
        return IntStream.range(0, count).mapToObj(description).toList();
    }
}
