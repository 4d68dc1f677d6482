package arcomat.live.robot;

import arcomat.model.Value;
import arcomat.model.Value.BooleanValue;
import arcomat.sim.device.Hardware;
import arcomat.sim.device.Key;

import java.util.function.Consumer;

/** {@code nxt.Button}. */
record Pressing(Routine routine, Hardware brick, Key key) implements Part {
    @Override
    public void sense(Consumer<Value> out) {
        routine.call(() -> out.accept(new BooleanValue((brick.keypad().down() & key.bit()) != 0)));
    }
}
