package arcomat.pipeline.campaign.joint;

import arcomat.pipeline.compile.Slot;

import org.jspecify.annotations.Nullable;

import java.util.ArrayList;
import java.util.List;
import java.util.Objects;

/**
 * What the ports of one robot's program have shown in the slices that have ended since somebody
 * looked last. What a port with delay shows is read before the step, all else after it.
 */
final class ShownSlices {
    private static final Integer NOTHING = 0;

    private final ProgramTaps program;
    private final List<Field> fields = new ArrayList<>();
    private final List<@Nullable Object[]> ended = new ArrayList<>();
    private @Nullable Object @Nullable [] current;

    ShownSlices(ProgramTaps program) {
        this.program = program;
    }

    /** Where a tap reads in the objects of a run. */
    private record Field(PortTap tap, Slot message, @Nullable Slot flag) {
        static Field of(PortTap tap, Object whole) {
            Object part = tap.fields().isEmpty() ? whole : Slot.follow(whole, tap.fields());
            Slot flag = tap.flag().isEmpty() ? null : new Slot(part, tap.flag());
            return new Field(tap, new Slot(part, tap.message()), flag);
        }

        @Nullable Object read() {
            if (flag != null && flag.get().equals(false)) {
                return null;
            }
            Object held = message.get();
            return tap.silentAtZero() && held.equals(NOTHING) ? null : held;
        }
    }

    void entered(Object object, String method) {
        if (program.isSlice(object, method)) {
            if (fields.isEmpty()) {
                program.taps().forEach(each -> fields.add(Field.of(each, object)));
            }
            current = new @Nullable Object[fields.size()];
            read(true);
        }
    }

    void left(Object object, String method) {
        if (program.isSlice(object, method)) {
            read(false);
            ended.add(Objects.requireNonNull(current));
        }
    }

    private void read(boolean before) {
        @Nullable Object[] slice = Objects.requireNonNull(current);
        for (int i = 0; i < slice.length; i++) {
            if (fields.get(i).tap().before() == before) {
                slice[i] = fields.get(i).read();
            }
        }
    }

    int count() {
        return ended.size();
    }

    /** The message; null where there is none, or no such slice. */
    @Nullable Object message(int slice, int tap) {
        return slice < ended.size() ? ended.get(slice)[tap] : null;
    }

    void forget() {
        ended.clear();
    }
}
