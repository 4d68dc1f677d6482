package parts.logic;

/** Tells from two light sensors where the line is; it is dark and as wide as they are apart. */
public final class LineStatus {
    public static final int NO_DRIFT = 0;
    public static final int DRIFT_LEFT = 1;
    public static final int DRIFT_RIGHT = 2;

    private final int dark;
    private boolean lost;
    private int drift;

    public LineStatus(int dark) {
        this.dark = dark;
    }

    public void look(int left, int right) {
        boolean leftSees = left < dark;
        boolean rightSees = right < dark;
        lost = !leftSees && !rightSees;
        if (leftSees == rightSees) {
            drift = NO_DRIFT;
        } else {
            drift = leftSees ? DRIFT_RIGHT : DRIFT_LEFT;
        }
    }

    public boolean isLost() {
        return lost;
    }

    public int drift() {
        return drift;
    }
}
