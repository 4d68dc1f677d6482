package arcomat.live.robot;

import arcomat.model.Value;
import arcomat.model.Value.IntegerValue;
import arcomat.sim.device.SensorSocket;

import java.util.function.Consumer;

/** {@code nxt.SoundSensor}. */
record Loudness(Routine routine, SensorSocket socket) implements Part {
    private static final int MOST_RAW = 1023;
    private static final int PERCENT = 100;

    @Override
    public void sense(Consumer<Value> out) {
        routine.call();
        routine.call(
                () -> {
                    int percent = (MOST_RAW - socket.rawLevel()) * PERCENT / MOST_RAW;
                    socket.observed(percent);
                    int heard = Math.max(0, Math.min(PERCENT, percent));
                    out.accept(new IntegerValue(heard));
                });
    }
}
