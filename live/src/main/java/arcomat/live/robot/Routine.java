package arcomat.live.robot;

import arcomat.sim.device.Processor;
import arcomat.sim.time.Timetable;
import arcomat.sim.time.VirtualTime;

import org.jspecify.annotations.Nullable;

import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Deque;
import java.util.List;
import java.util.function.LongSupplier;

/**
 * What a thread of a program does, told as steps with waits between them: so it needs no thread.
 * What a step adds comes behind what it has added before, and before all that was ahead.
 */
final class Routine extends Timetable {
    private final VirtualTime time;
    private final Deque<Step> ahead = new ArrayDeque<>();
    private final List<Step> added = new ArrayList<>();
    private long due;

    /**
     * @param moment to wait for, asked when everything before is done; null for none
     */
    private record Step(@Nullable LongSupplier moment, Runnable action) {}

    Routine(VirtualTime time) {
        super(Rank.PROGRAM);
        this.time = time;
    }

    /** Begins at this moment, as soon as it is its turn. */
    void start(Runnable first) {
        ahead.add(new Step(null, first));
        due = time.now();
        time.start(this, due);
    }

    /** At once. */
    void then(Runnable action) {
        added.add(new Step(null, action));
    }

    /** A device is called: that takes a little time, and then the device does what it should. */
    void call(Runnable action) {
        until(() -> time.now() + Processor.CALL, action);
    }

    /** A device is called that does nothing which could be seen. */
    void call() {
        call(() -> {});
    }

    /** A loop asks whether it is to go round once more. */
    void loop() {
        until(() -> time.now() + Processor.ROUND, () -> {});
    }

    /**
     * Calls and loops of which nobody sees anything, and which end with a loop.
     *
     * @param microseconds of all of them
     */
    void idle(long microseconds) {
        if (microseconds > Processor.ROUND) {
            until(() -> time.now() + microseconds - Processor.ROUND, () -> {});
        }
        loop();
    }

    /** At a moment in microseconds; where that is past, when all others have had their turn. */
    void until(LongSupplier moment, Runnable action) {
        added.add(new Step(moment, action));
    }

    /** The wait for a moment is over. */
    void wake() {
        if (due > time.now()) {
            due = time.now();
            time.restart(this, due);
        }
    }

    /** Leaves out everything that is ahead. */
    void drop() {
        ahead.clear();
        added.clear();
    }

    @Override
    protected long act() {
        do {
            goOn();
        } while (!ahead.isEmpty() && ahead.element().moment() == null);
        due = ahead.isEmpty() ? VirtualTime.NEVER : moment();
        return due;
    }

    private void goOn() {
        ahead.remove().action().run();
        for (int i = added.size() - 1; i >= 0; i--) {
            ahead.push(added.get(i));
        }
        added.clear();
    }

    private long moment() {
        LongSupplier moment = ahead.element().moment();
        return moment == null ? time.now() : Math.max(time.now(), moment.getAsLong());
    }
}
