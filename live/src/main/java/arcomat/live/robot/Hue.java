package arcomat.live.robot;

import arcomat.model.Type;
import arcomat.model.Value;
import arcomat.model.Value.EnumValue;
import arcomat.sim.device.SensorSocket;

import java.util.List;
import java.util.function.Consumer;

/**
 * {@code nxt.ColorSensor}.
 *
 * @param colors the constants of {@code nxt.Brick.Color}
 */
record Hue(Routine routine, SensorSocket socket, Type.EnumType colors) implements Part {
    /** Colours as leJOS counts them, from 0. */
    private static final List<String> COUNTED =
            List.of("red", "green", "blue", "yellow", "magenta", "orange", "white", "black");

    private static final String NONE = "none";

    @Override
    public void sense(Consumer<Value> out) {
        routine.call();
        routine.call(
                () -> {
                    int seen = socket.eye().color();
                    socket.observed(seen);
                    out.accept(new EnumValue(colors, constant(seen)));
                });
    }

    private int constant(int counted) {
        boolean known = counted >= 0 && counted < COUNTED.size();
        int constant = known ? colors.constants().indexOf(COUNTED.get(counted)) : -1;
        return constant < 0 ? colors.constants().indexOf(NONE) : constant;
    }
}
