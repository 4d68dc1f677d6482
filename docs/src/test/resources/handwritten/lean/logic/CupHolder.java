package lean.logic;

/** Whether there is a full cup: two equal readings in a row are needed to change the verdict. */
public final class CupHolder {
    private boolean before;
    private boolean full;

    public boolean isFull() {
        return full;
    }

    public void feel(boolean pressed) {
        if (pressed == before) {
            full = pressed;
        }
        before = pressed;
    }
}
