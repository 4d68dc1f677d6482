package arcomat.live.robot;

import arcomat.model.Value;
import arcomat.model.Value.IntegerValue;
import arcomat.sim.device.SensorSocket;

import java.util.function.Consumer;

/**
 * {@code nxt.LightSensor}.
 *
 * @param dark reading that counts as 0 percent
 * @param bright reading that counts as 100
 */
record Brightness(Routine routine, SensorSocket socket, int dark, int bright) implements Part {
    private static final int MOST_RAW = 1023;
    private static final int PERCENT = 100;

    @Override
    public void sense(Consumer<Value> out) {
        routine.call(
                () -> {
                    int percent = percent(socket.rawLevel());
                    routine.call(() -> socket.observed(percent));
                    int seen = Math.max(0, Math.min(PERCENT, percent));
                    routine.then(() -> out.accept(new IntegerValue(seen)));
                });
    }

    /** A dark surface has a high raw value. */
    private int percent(int raw) {
        int zero = MOST_RAW - dark;
        int hundred = MOST_RAW - bright;
        return hundred == zero ? 0 : PERCENT * (raw - zero) / (hundred - zero);
    }
}
