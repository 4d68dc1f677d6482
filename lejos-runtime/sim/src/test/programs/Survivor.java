import lejos.nxt.LCD;
import lejos.util.Delay;

/** A thread outlives main; a daemon does not outlive the last thread. */
public class Survivor {
    public static void main(String[] args) {
        Thread survivor =
                new Thread() {
                    public void run() {
                        Delay.msDelay(300);
                        LCD.drawString(isDaemon() ? "daemon" : "survivor", 0, 0);
                    }
                };
        Thread daemon =
                new Thread() {
                    public void run() {
                        Delay.msDelay(400);
                        LCD.drawString("too late", 0, 1);
                    }
                };
        daemon.setDaemon(true);
        daemon.start();
        survivor.start();
    }
}
