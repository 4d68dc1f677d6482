import lejos.nxt.Button;
import lejos.nxt.LCD;
import lejos.util.Delay;

/** A tap that nobody waits for is gone; one that is still down when somebody does is not. */
public class Taps {
    public static void main(String[] args) {
        Delay.msDelay(1000);
        LCD.drawInt(Button.waitForAnyPress(500), 0, 0);
        Delay.msDelay(1000);
        LCD.drawInt(Button.waitForAnyPress(500), 0, 1);
        Button.RIGHT.waitForPress(); // forgets what happened to LEFT
        LCD.drawInt(Button.waitForAnyEvent(5000), 0, 2);
        LCD.drawInt(Button.waitForAnyEvent(100), 0, 3);
    }
}
