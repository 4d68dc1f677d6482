package arcomat.sim;

import arcomat.sim.script.Action;
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
            perform(steps.get(next++).action());
        }
        return due();
    }

    private void perform(Action action) {
        if (action instanceof Action.Expose expose) {
            brick.expose(expose.socket(), expose.stimulus());
        } else if (action instanceof Action.Press press) {
            brick.press(press.key());
        } else if (action instanceof Action.Release release) {
            brick.release(release.key());
        } else {
            brick.stop();
        }
    }
}
