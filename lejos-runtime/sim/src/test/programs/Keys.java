import lejos.nxt.Button;
import lejos.nxt.LCD;
import lejos.util.Delay;

/** What is down, and up again, is seen when no key has changed for a while. */
public class Keys {
    public static void main(String[] args) {
        int seen = 0;
        while (true) {
            if (Button.readButtons() != seen) {
                seen = Button.readButtons();
                LCD.drawInt(seen, 0, 0);
            }
            Delay.msDelay(10);
        }
    }
}
