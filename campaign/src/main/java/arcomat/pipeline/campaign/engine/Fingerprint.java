package arcomat.pipeline.campaign.engine;

import arcomat.pipeline.world.Onlooker;
import arcomat.pipeline.world.Witness.Instruments;
import arcomat.sim.device.LineNotes;
import arcomat.world.Scene;

import java.util.List;

/**
 * Tells apart runs that go apart anywhere: what moves at each step, and what displays show. Equal
 * within one process only.
 */
final class Fingerprint implements Onlooker {
    private static final int FACTOR = 31;

    private final Onlooker beside;
    private long bits;

    /**
     * @param beside sees the same
     */
    Fingerprint(Onlooker beside) {
        this.beside = beside;
    }

    long bits() {
        return bits;
    }

    @Override
    public void see(Scene scene, Instruments instruments) {
        beside.see(scene, instruments);
        add(scene);
        for (int i = 0; i < scene.robots().size(); i++) {
            add(instruments.display(i));
        }
    }

    @Override
    public void entered(String robot, Object object, String method) {
        beside.entered(robot, object, method);
        add(robot + object.getClass().getName() + method);
    }

    @Override
    public void left(String robot, Object object, String method) {
        beside.left(robot, object, method);
    }

    /** What was reached is in the row. */
    @Override
    public void noted(String robot, List<LineNotes> notes) {
        beside.noted(robot, notes);
    }

    private void add(Object seen) {
        bits = FACTOR * bits + seen.hashCode();
    }
}
