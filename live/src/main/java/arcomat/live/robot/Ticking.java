package arcomat.live.robot;

import arcomat.model.Type;
import arcomat.model.Value;
import arcomat.model.Value.EnumValue;
import arcomat.sim.device.Hardware;

import java.util.function.Consumer;

/** {@code nxt.Timer}. It looks at the clock. */
final class Ticking implements Part {
    private final Routine routine;
    private final Hardware brick;
    private final Type.EnumType ticks;
    private final int period;
    private long next;

    /**
     * @param ticks the one constant of {@code nxt.Brick.Tick}
     * @param period in milliseconds
     */
    Ticking(Routine routine, Hardware brick, Type.EnumType ticks, int period) {
        this.routine = routine;
        this.brick = brick;
        this.ticks = ticks;
        this.period = period;
    }

    @Override
    public void begin() {
        routine.call(() -> next = brick.milliseconds() + period);
    }

    @Override
    public void sense(Consumer<Value> out) {
        routine.call(
                () -> {
                    long late = brick.milliseconds() - next;
                    if (late >= 0) {
                        next += (late / period + 1) * period;
                        out.accept(new EnumValue(ticks, 0));
                    }
                });
    }
}
