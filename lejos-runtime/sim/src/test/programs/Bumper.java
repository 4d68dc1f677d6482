import lejos.nxt.Button;
import lejos.nxt.LCD;
import lejos.nxt.Motor;
import lejos.nxt.SensorPort;
import lejos.nxt.TouchSensor;
import lejos.nxt.UltrasonicSensor;
import lejos.util.Delay;

/** Drives until something is near or touched; a cycle of 100 ms; ESCAPE ends. */
public class Bumper {
    public static void main(String[] args) {
        TouchSensor touch = new TouchSensor(SensorPort.S4);
        UltrasonicSensor eye = new UltrasonicSensor(SensorPort.S1);
        Motor.A.setSpeed(300);
        long next = System.currentTimeMillis();
        while (!Button.ESCAPE.isDown()) {
            boolean free = eye.getDistance() > 20 && !touch.isPressed();
            if (free) {
                Motor.A.forward();
            } else {
                Motor.A.stop(true);
            }
            LCD.drawString(free ? "free" : "stop", 0, 0);
            next += 100;
            Delay.msDelay(next - System.currentTimeMillis());
        }
        Motor.A.stop(true);
        System.out.println("bye");
    }
}
