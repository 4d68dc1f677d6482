package arcomat.live.robot;

import arcomat.pipeline.WrongUse;
import arcomat.pipeline.check.LoweredModels;
import arcomat.pipeline.world.WorldRecorder;
import arcomat.pipeline.world.WorldRun;
import arcomat.sim.Brick;
import arcomat.sim.BrickRoom;
import arcomat.sim.device.Limits;
import arcomat.world.Kind;
import arcomat.world.Recording;
import arcomat.world.Seeds;
import arcomat.world.World;

import java.util.HashMap;
import java.util.Map;
import java.util.Objects;

/** A world with the programs of its robots, which are interpreted. */
public final class RobotPrograms {
    private final World world;
    private final Map<String, RobotProgram> programs;

    private RobotPrograms(World world, Map<String, RobotProgram> programs) {
        this.world = world;
        this.programs = programs;
    }

    /**
     * @throws WrongUse where a robot's program cannot be interpreted, and why
     */
    public static RobotPrograms of(World world, LoweredModels models) throws WrongUse {
        Map<String, RobotProgram> programs = new HashMap<>();
        for (World.Robot robot : world.robots()) {
            requireOwnSensors(robot);
            Kind.Program program = robot.kind().program();
            if (!programs.containsKey(program.key())) {
                programs.put(program.key(), RobotProgram.of(program, models));
            }
        }
        return new RobotPrograms(world, programs);
    }

    private static void requireOwnSensors(World.Robot robot) throws WrongUse {
        for (Kind.Described each : robot.kind().described()) {
            throw new WrongUse(
                    "robots of kind '%s' have the device '%s', which is told in Java; use arcomat"
                            + " world",
                    robot.kind().name(), each.device());
        }
    }

    /** Runs the world to its goal, or to its end, on bricks without limits. */
    public Recording run(Seeds seeds) {
        BrickRoom room = BrickRoom.withoutThreads(Limits.NONE);
        WorldRecorder recorder = new WorldRecorder(world, seeds);
        WorldRun.run(world, seeds, room, robot -> brick(robot, room), recorder);
        return recorder.recording();
    }

    private Brick brick(World.Robot robot, BrickRoom room) {
        String key = robot.kind().program().key();
        return Objects.requireNonNull(programs.get(key), key).start(robot.name(), room);
    }
}
