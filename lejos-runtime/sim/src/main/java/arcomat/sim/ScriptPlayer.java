package arcomat.sim;

import arcomat.sim.script.Step;
import arcomat.sim.time.Timetable;
import arcomat.sim.time.VirtualTime;

import java.util.List;

/** Does to a brick what a script says. */
final class ScriptPlayer extends Timetable {
    private final SimulatedBrick brick;
    private final List<Step> steps;
    private int next;

    ScriptPlayer(SimulatedBrick brick, List<Step> steps) {
        this.brick = brick;
        this.steps = steps;
    }

    /** When the next step is due, in microseconds. */
    long due() {
        return next < steps.size()
                ? steps.get(next).time() * VirtualTime.MILLISECOND
                : VirtualTime.NEVER;
    }

    @Override
    protected long act() {
        long now = due();
        while (due() == now && now != VirtualTime.NEVER) {
            steps.get(next++).action().perform(brick);
        }
        return due();
    }
}
