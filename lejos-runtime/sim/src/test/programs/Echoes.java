import lejos.nxt.LCD;
import lejos.nxt.SensorPort;
import lejos.nxt.UltrasonicSensor;

/** What the ultrasonic sensor tells in its modes, and what it refuses. */
public class Echoes {
    private static int row;

    public static void main(String[] args) {
        UltrasonicSensor eye = new UltrasonicSensor(SensorPort.S1);
        show(eye.getProductID() + " " + eye.getUnits() + " " + eye.getActualMode());
        int[] echoes = {-7, -7, -7};
        show("near " + eye.getDistances(echoes) + " " + echoes[0] + " " + echoes[1]);
        sleep(300); // nothing is in range any more
        show("far " + eye.getDistances(echoes) + " " + eye.getRanges().length);
        sleep(300);
        eye.ping();
        sleep(300); // whatever happens now, the echo is that of the ping
        show("ping " + eye.getDistance() + " " + eye.getDistances(echoes, 1, 1) + echoes[1]);
        eye.reset();
        show("reset " + eye.getMode() + eye.getActualMode() + refuses(eye));
        try {
            eye.setMode(9);
        } catch (IllegalArgumentException e) {
            show("no mode " + eye.getMode());
        }
        eye.continuous();
        show("on " + eye.getDistance() + " " + eye.setContinuousInterval(5));
        sleep(1000); // unplugged
        show("gone " + eye.getDistance() + " " + eye.getDistances(echoes) + eye.off());
    }

    private static String refuses(UltrasonicSensor eye) {
        try {
            eye.getDistance();
            return " answers";
        } catch (IllegalStateException e) {
            return " refuses";
        }
    }

    private static void show(String text) {
        LCD.drawString(text, 0, row++);
    }

    private static void sleep(int milliseconds) {
        lejos.util.Delay.msDelay(milliseconds);
    }
}
