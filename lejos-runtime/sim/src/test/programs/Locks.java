import lejos.nxt.LCD;

/**
 * Locks taken twice, held by methods of all kinds, given back by errors, and waited for in vain.
 */
public class Locks {
    synchronized long add(long a, double b, float c, int[] d, String e, boolean f) {
        return f ? a + (long) b + (long) c + d[0] + e.length() : add(a, b, c, d, e, true);
    }

    static synchronized void fail() {
        throw new IllegalStateException("as expected");
    }

    public static void main(String[] args) throws InterruptedException {
        Locks locks = new Locks();
        LCD.drawInt((int) locks.add(1L, 2.0, 3.0f, new int[] {4}, "five.", false), 0, 0);
        try {
            fail();
        } catch (IllegalStateException e) {
            LCD.drawString(e.getMessage(), 0, 1);
        }
        Thread other =
                new Thread() {
                    public void run() {
                        synchronized (Locks.class) {
                            LCD.drawString("free again", 0, 2);
                        }
                    }
                };
        other.start();
        other.join();
        synchronized (locks) {
            locks.wait(250);
        }
        LCD.drawInt((int) System.currentTimeMillis() / 50, 0, 3);
        try {
            locks.notify();
        } catch (IllegalMonitorStateException e) {
            LCD.drawString("not mine", 0, 4);
        }
    }
}
