package arcomat.live.robot;

import arcomat.model.Value;
import arcomat.model.Value.IntegerValue;
import arcomat.sim.bus.Sonar;
import arcomat.sim.device.Hardware;
import arcomat.sim.device.I2CBus;
import arcomat.sim.device.SensorSocket;
import arcomat.sim.time.VirtualTime;

import java.util.function.Consumer;

/**
 * {@code nxt.UltrasonicSensor}: a request over two wires, with the rests that the device needs. It
 * measures every 60 ms; in between the last distance is seen again.
 */
final class Echo implements Part {
    private static final int NOTHING = 255;
    private static final int MEASURING = 60;

    /** Milliseconds between requests, and until an echo can be read. */
    private static final int REST = 5;

    private static final int LISTENING = 30;

    /** Milliseconds to wait for a bus that is not free. */
    private static final int PATIENCE = 10;

    private static final int ADDRESS = 0x02;
    private static final byte ECHOES = 0x42;

    private final Routine routine;
    private final Hardware brick;
    private final SensorSocket socket;
    private final byte[] bytes = {ECHOES};
    private final byte[] answer = new byte[1];
    private int distance = NOTHING;
    private long next;
    private long nextRequest;
    private long nextEcho;

    Echo(Routine routine, Hardware brick, SensorSocket socket) {
        this.routine = routine;
        this.brick = brick;
        this.socket = socket;
    }

    @Override
    public void begin() {
        routine.call(() -> socket.bus().enable(false));
        routine.call(() -> socket.bus().assume(new Sonar()));
    }

    @Override
    public void sense(Consumer<Value> out) {
        routine.call(() -> measure(brick.milliseconds()));
        routine.then(() -> out.accept(new IntegerValue(distance)));
    }

    private void measure(long now) {
        if (now >= next) {
            routine.until(() -> nextEcho * VirtualTime.MILLISECOND, () -> {});
            routine.until(() -> nextRequest * VirtualTime.MILLISECOND, this::request);
            routine.then(() -> next = now + MEASURING);
        }
    }

    private void request() {
        routine.call(
                () -> {
                    int begun = begun();
                    if (begun == I2CBus.BUS_BUSY) {
                        routine.until(() -> brick.tickAfter(PATIENCE), () -> answer(begun()));
                    } else {
                        answer(begun);
                    }
                });
    }

    private int begun() {
        return socket.bus().start(ADDRESS, bytes, 0, 1, 1);
    }

    private void answer(int begun) {
        if (begun < 0) {
            silence();
        } else {
            routine.until(() -> socket.bus().due(), this::complete);
        }
    }

    private void complete() {
        if (socket.bus().complete(answer, 0, 1) == 1) {
            nextRequest = brick.milliseconds() + REST;
            nextEcho = brick.milliseconds() + LISTENING;
            distance = answer[0] & NOTHING;
        } else {
            silence();
        }
    }

    private void silence() {
        nextRequest = brick.milliseconds() + REST;
        routine.call(() -> distance = socket.observed(NOTHING));
    }
}
