import lejos.nxt.Button;
import lejos.nxt.LCD;
import lejos.nxt.Sound;

/** Waits for buttons: pressed, released, none in time. */
public class Buttons {
    public static void main(String[] args) {
        LCD.drawInt(Button.waitForAnyPress(), 0, 0);
        Sound.playTone(440, 100);
        Button.ENTER.waitForPressAndRelease();
        LCD.drawInt(Button.waitForAnyPress(500), 0, 1);
        Sound.twoBeeps();
        while (Button.RIGHT.isUp()) {
            // asking takes time, so this ends
        }
        System.exit(0);
        LCD.drawString("never", 0, 7);
    }
}
