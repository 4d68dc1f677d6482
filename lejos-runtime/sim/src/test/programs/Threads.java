import lejos.nxt.LCD;
import lejos.util.Delay;

/** Two threads that share a lock, wait for each other and are joined; a daemon that never ends. */
public class Threads {
    private static final Object LOCK = new Object();
    private static int count;

    static class Worker extends Thread {
        public void run() {
            for (int i = 0; i < 3; i++) {
                Delay.msDelay(100);
                increase();
            }
            synchronized (LOCK) {
                Delay.msDelay(50); // asleep with the lock: main must wait for it
                LOCK.notifyAll();
            }
        }
    }

    static synchronized void increase() {
        int before = count;
        Delay.msDelay(10);
        count = before + 1;
        LCD.drawInt(count, 0, 0);
    }

    public static void main(String[] args) throws InterruptedException {
        Worker first = new Worker();
        Worker second = new Worker();
        Thread idle =
                new Thread(
                        new Runnable() {
                            public void run() {
                                while (true) {
                                    Thread.yield();
                                }
                            }
                        });
        idle.setDaemon(true);
        idle.start();
        first.start();
        second.start();
        synchronized (LOCK) {
            LOCK.wait();
        }
        LCD.drawString("woken", 0, 1);
        first.join();
        second.join();
        LCD.drawString(first.isAlive() ? "alive" : "gone", 0, 2);
        Thread sleeper =
                new Thread(
                        new Runnable() {
                            public void run() {
                                try {
                                    Thread.sleep(100000);
                                } catch (InterruptedException e) {
                                    LCD.drawString("interrupted", 0, 3);
                                }
                            }
                        });
        sleeper.start();
        Thread.sleep(100);
        sleeper.interrupt();
        LCD.drawString(Thread.currentThread() == sleeper ? "odd" : "main", 0, 4);
    }
}
