import lejos.nxt.Button;
import lejos.nxt.ButtonListener;
import lejos.nxt.LCD;
import lejos.nxt.Motor;
import lejos.nxt.SensorPort;
import lejos.nxt.SensorPortListener;
import lejos.nxt.Sound;
import lejos.nxt.TouchSensor;
import lejos.robotics.RegulatedMotor;
import lejos.robotics.RegulatedMotorListener;
import lejos.util.Delay;
import lejos.util.Timer;
import lejos.util.TimerListener;

/** Listeners of a button, a sensor, a motor and a timer; none of them keeps the program going. */
public class Listeners implements ButtonListener, SensorPortListener, RegulatedMotorListener {
    private static int ticks;

    public static void main(String[] args) {
        Listeners all = new Listeners();
        Button.LEFT.addButtonListener(all);
        TouchSensor touch = new TouchSensor(SensorPort.S2);
        SensorPort.S2.addSensorPortListener(all);
        Motor.B.addListener(all);
        Timer timer =
                new Timer(
                        250,
                        new TimerListener() {
                            public void timedOut() {
                                LCD.drawInt(++ticks, 0, 7);
                            }
                        });
        timer.start();
        Motor.B.rotate(180, true);
        Delay.msDelay(1000);
        Motor.B.rotate(-180); // tells its end before it returns
        LCD.drawString("back", 0, 6);
        timer.stop();
        Delay.msDelay(1000);
        LCD.drawInt(ticks + (touch.isPressed() ? 100 : 0), 6, 6);
    }

    public void buttonPressed(Button button) {
        LCD.drawString("pressed " + button.getId(), 0, 0);
    }

    public void buttonReleased(Button button) {
        LCD.drawString("released", 0, 0);
        Sound.beepSequence();
    }

    public void stateChanged(SensorPort port, int before, int now) {
        LCD.drawString(port.getId() + ":" + before + " " + now + "  ", 0, 1);
    }

    public void rotationStarted(RegulatedMotor motor, int count, boolean stalled, long time) {
        LCD.drawString("starts " + count + "  ", 0, 2);
    }

    public void rotationStopped(RegulatedMotor motor, int count, boolean stalled, long time) {
        LCD.drawString("stops " + count + "  ", 0, 2);
    }
}
