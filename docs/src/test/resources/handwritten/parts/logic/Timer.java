package parts.logic;

/** Is alert once, a number of slices after it was started. A start while it runs starts it anew. */
public final class Timer {
    private final int slices;
    private int left;
    private boolean alert;

    public Timer(int slices) {
        this.slices = slices;
    }

    public boolean isAlert() {
        return alert;
    }

    public void step(boolean start) {
        alert = false;
        if (start) {
            left = slices - 1;
        } else if (left > 0) {
            left--;
            alert = left == 0;
        }
    }
}
