package nxt.sensors;

/** Platform component nxt.Button on the brick. */
public final class Button {
    /**
     * The constants of nxt.Brick.Key in their order; ESCAPE ends the program and is not among them.
     */
    private static final int ENTER = 1;

    private static final int LEFT = 2;

    public boolean pressed;

    private final lejos.nxt.Button key;

    public Button(int key) {
        this.key =
                key == ENTER
                        ? lejos.nxt.Button.ENTER
                        : key == LEFT ? lejos.nxt.Button.LEFT : lejos.nxt.Button.RIGHT;
    }

    /** Samples the key: the start of a slice. */
    public void sense() {
        pressed = key.isDown();
    }
}
