package arcomat.world;

import arcomat.source.Span;

/**
 * Somebody who steps on the line when coffee comes, takes it and goes away to drink it.
 *
 * @param spot where they step
 * @param thirst seconds from one cup to the wish for the next
 */
public record Drinker(String name, Point spot, double thirst, Span place) {
    /** Of the legs of a person, in mm. */
    private static final double RADIUS = 100;

    /** What they fill of the floor. */
    Disc legs() {
        return new Disc(spot, RADIUS);
    }
}
