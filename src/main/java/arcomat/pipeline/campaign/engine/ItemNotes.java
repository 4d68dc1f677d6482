package arcomat.pipeline.campaign.engine;

import arcomat.campaign.coverage.ReachedItems;
import arcomat.pipeline.world.Onlooker;
import arcomat.pipeline.world.Witness.Instruments;
import arcomat.world.Scene;
import arcomat.world.World;

import java.util.BitSet;

/** What the robots of one run have covered, all together. */
final class ItemNotes implements Onlooker {
    private final boolean known;
    private final Onlooker beside;
    private final BitSet numbers = new BitSet();

    /**
     * @param beside sees the same
     */
    ItemNotes(ItemProbes probes, World world, Onlooker beside) {
        this.known =
                world.robots().stream()
                        .anyMatch(robot -> probes.knows(robot.kind().program().key()));
        this.beside = beside;
    }

    @Override
    public void see(Scene scene, Instruments instruments) {
        beside.see(scene, instruments);
    }

    @Override
    public void entered(String robot, Object object, String method) {
        beside.entered(robot, object, method);
    }

    @Override
    public void left(String robot, Object object, String method) {
        beside.left(robot, object, method);
    }

    @Override
    public void reached(String robot, BitSet ofRobot) {
        numbers.or(ofRobot);
    }

    /** Not known where no program of the world was made of models. */
    ReachedItems reached() {
        return known ? ReachedItems.of(numbers) : ReachedItems.UNKNOWN;
    }
}
