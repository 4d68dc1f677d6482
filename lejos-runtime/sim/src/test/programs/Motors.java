import lejos.nxt.LCD;
import lejos.nxt.Motor;
import lejos.nxt.MotorPort;
import lejos.nxt.NXTMotor;
import lejos.util.Delay;

/** What motors do and how long it takes, on the screen. */
public class Motors {
    public static void main(String[] args) {
        Motor.B.setSpeed(360);
        Motor.B.setAcceleration(720);
        Motor.B.rotate(360); // half a second up, half a second at full speed, half a second down
        show(0);
        Motor.B.rotateTo(0, true);
        Delay.msDelay(500);
        show(1);
        Motor.B.waitComplete();
        show(2);
        Motor.B.forward();
        Delay.msDelay(1000);
        Motor.B.stop(); // waits half a second
        show(3);
        NXTMotor raw = new NXTMotor(MotorPort.C);
        raw.setPower(50);
        Delay.msDelay(1000);
        LCD.drawInt(raw.getTachoCount() / 10, 4, 0, 4);
        raw.flt();
    }

    private static void show(int row) {
        LCD.drawInt(Motor.B.getTachoCount(), 4, 0, row);
        LCD.drawInt(Motor.B.getRotationSpeed(), 5, 5, row);
    }
}
