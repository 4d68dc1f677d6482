package arcomat.world;

/**
 * Something that people would tell of.
 *
 * @param who name of a robot
 * @param whom name of another robot or of a drinker; empty where there is none
 */
public record Happening(What what, String who, String whom) {
    /** What can happen. */
    public enum What {
        /** A robot has run into something. */
        COLLISION,
        /** A robot has got a cup. */
        CUP_GIVEN,
        /** A cup has fallen on the floor. */
        CUP_LOST,
        /** The cup of a robot has been filled. */
        COFFEE_POURED,
        /** Coffee has run on the floor. */
        COFFEE_SPILT,
        /** A drinker has taken a cup. */
        COFFEE_TAKEN
    }
}
