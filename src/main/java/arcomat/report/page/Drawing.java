package arcomat.report.page;

import java.util.List;

/**
 * A picture beside a run. What the tracks show at a step is marked in it.
 *
 * @param svg an element {@code svg} without scripts and styles
 * @param tracks names of the tracks that it follows
 */
public record Drawing(String title, String svg, List<String> tracks) {
    public Drawing {
        tracks = List.copyOf(tracks);
    }
}
