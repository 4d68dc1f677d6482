package lejos.nxt;

/** Is told of a button. */
public interface ButtonListener {
    void buttonPressed(Button b);

    void buttonReleased(Button b);
}
