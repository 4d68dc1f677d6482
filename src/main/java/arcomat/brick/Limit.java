package arcomat.brick;

/** Says that there is more of something than there is room for. */
final class Limit {
    /** From here on there is a warning: part of what there is room for. */
    static final double NEARLY = 0.8;

    private Limit() {}

    /**
     * @param who what has too much
     * @param what of what it has too much, in the plural
     * @param advice what to do
     */
    static String message(String who, int number, String what, int room, String advice) {
        return "%s has %d %s, but the brick has room for %d; %s"
                .formatted(who, number, what, room, advice);
    }
}
