package arcomat.live.robot;

import arcomat.model.Value;
import arcomat.model.Value.BooleanValue;
import arcomat.sim.device.SensorSocket;

import java.util.function.Consumer;

/** {@code nxt.TouchSensor}. */
record Touching(Routine routine, SensorSocket socket) implements Part {
    /** Below this raw value a switch counts as pressed. */
    private static final int RAW_PRESSED = 600;

    @Override
    public void sense(Consumer<Value> out) {
        routine.call(
                () -> {
                    boolean pressed = socket.rawSwitch() < RAW_PRESSED;
                    routine.call(() -> socket.observed(pressed ? 1 : 0));
                    routine.then(() -> out.accept(new BooleanValue(pressed)));
                });
    }
}
