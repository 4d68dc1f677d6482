import lejos.nxt.Button;
import lejos.nxt.Motor;
import lejos.robotics.subsumption.Arbitrator;
import lejos.robotics.subsumption.Behavior;
import lejos.util.Delay;

/** Drives until a button is pressed, then backs up; ends when there is nothing to do. */
public class Behaviors {
    private static int rounds;

    public static void main(String[] args) {
        new Arbitrator(new Behavior[] {new Drive(), new BackUp()}, true).start();
        System.out.println("idle");
    }

    private static class Drive implements Behavior {
        private boolean suppressed;

        public boolean takeControl() {
            return rounds < 2;
        }

        public void action() {
            suppressed = false;
            Motor.A.forward();
            while (!suppressed) {
                Delay.msDelay(10);
            }
            Motor.A.stop(true);
        }

        public void suppress() {
            suppressed = true;
        }
    }

    private static class BackUp implements Behavior {
        public boolean takeControl() {
            return Button.LEFT.isDown();
        }

        public void action() {
            rounds++;
            Motor.A.rotate(-90);
        }

        public void suppress() {}
    }
}
