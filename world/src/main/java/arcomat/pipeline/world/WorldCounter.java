package arcomat.pipeline.world;

import arcomat.sim.device.LineNotes;
import arcomat.sim.device.Observer;
import arcomat.sim.device.SilentObserver;
import arcomat.sim.time.VirtualTime;
import arcomat.world.Scene;
import arcomat.world.Summary;
import arcomat.world.Tally;
import arcomat.world.World;
import arcomat.world.World.Robot;

import java.util.List;

/** Keeps of a run what a campaign asks, and no frames. */
final class WorldCounter implements Witness {
    private final Tally tally;
    private final Onlooker beside;

    /**
     * @param beside sees the same
     */
    WorldCounter(World world, long seed, Onlooker beside) {
        this.beside = beside;
        tally = new Tally(world, seed);
    }

    Summary summary() {
        return tally.summary();
    }

    @Override
    public Observer of(Robot robot) {
        return new SilentObserver() {
            @Override
            public void late(long from, long until) {
                tally.late(robot.name(), until - from);
            }

            @Override
            public void entered(long time, Object object, String method) {
                beside.entered(robot.name(), object, method);
            }

            @Override
            public void left(long time, Object object, String method) {
                beside.left(robot.name(), object, method);
            }

            @Override
            public void packetSent(long time, byte[] packet, int length) {
                tally.sent((int) (time / VirtualTime.MILLISECOND));
            }
        };
    }

    @Override
    public void see(Scene scene, Instruments instruments) {
        tally.see(scene);
        beside.see(scene, instruments);
    }

    @Override
    public void noted(String robot, List<LineNotes> notes) {
        beside.noted(robot, notes);
    }

    @Override
    public void failed(String robot, String reason) {
        tally.failed(robot, reason);
    }
}
