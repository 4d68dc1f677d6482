package arcomat.pipeline.world;

import arcomat.sim.Brick;
import arcomat.sim.BrickRoom;
import arcomat.sim.Laboratory;
import arcomat.sim.SimulatedBrick;
import arcomat.sim.device.Limits;
import arcomat.sim.device.MotorName;
import arcomat.sim.device.SensorName;
import arcomat.sim.device.Stimulus;
import arcomat.world.Device;
import arcomat.world.Physics;
import arcomat.world.Scene;
import arcomat.world.Seeds;
import arcomat.world.Senses;
import arcomat.world.World;

import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.function.Supplier;

/**
 * A world and the bricks of its robots in lock step: each step of the world takes the speeds of the
 * shafts as they are, moves everything, and shows the sensors what they see next. A run depends on
 * the world, its programs and the seeds, and on nothing else.
 */
public final class WorldRun implements Witness.Instruments {
    private static final MotorName[] MOTORS = MotorName.values();
    private static final SensorName[] SOCKETS = SensorName.values();
    private static final long SECOND = 1000;

    /** How often to look whether a goal is reached, in milliseconds. */
    private static final long WATCH = 100;

    private final World world;
    private final Physics physics;
    private final Senses senses;
    private final BrickRoom room;
    private final Brick[] bricks;
    private final List<List<Device.Sensor>> sensors = new ArrayList<>();
    private final double[][] shafts;
    private final List<List<Supplier<Stimulus>>> sources = new ArrayList<>();
    private final Witness witness;

    @SuppressWarnings("NullAway.Init") // a run begins with it
    private Scene scene;

    private WorldRun(World world, Seeds seeds, BrickRoom room, Witness witness) {
        this.world = world;
        this.room = room;
        this.witness = witness;
        int count = world.robots().size();
        physics = new Physics(world, seeds.first());
        senses = new Senses(world, seeds);
        bricks = new Brick[count];
        shafts = new double[count][MOTORS.length];
        world.robots().forEach(robot -> sensors.add(robot.kind().sensors()));
        for (int i = 0; i < count; i++) {
            sources.add(sources(i));
        }
    }

    /** What sensors see is looked at when their programs ask: most of the time none does. */
    private List<Supplier<Stimulus>> sources(int index) {
        List<Supplier<Stimulus>> sources = new ArrayList<>();
        for (Device.Sensor sensor : sensors.get(index)) {
            sources.add(() -> Stimulus.value(senses.read(scene, index, sensor)));
        }
        return sources;
    }

    /** Brings the robots of a world to work. */
    @FunctionalInterface
    public interface Starter {
        /** The brick of a robot, which is switched on at this moment and has what it needs. */
        Brick start(World.Robot robot);
    }

    /**
     * Runs a world to its goal, or to its end, with jars on its bricks.
     *
     * @param equipment by the names of robots
     * @param patience how long it may take by the PC's clock
     * @param limits those of a brick that programs meet
     * @throws arcomat.sim.time.OutOfPatience where it takes longer
     */
    static void run(
            World world,
            Seeds seeds,
            Map<String, WorldPrograms.Equipment> equipment,
            Duration patience,
            Limits limits,
            Witness witness) {
        try (Laboratory laboratory = new Laboratory(limits)) {
            laboratory.limit(patience);
            Starter jars =
                    robot -> {
                        WorldPrograms.Equipment own =
                                Objects.requireNonNull(equipment.get(robot.name()));
                        SimulatedBrick brick =
                                laboratory.place(
                                        robot.name(), Objects.requireNonNull(own.program()));
                        own.devices().plugInto(brick);
                        return brick;
                    };
            run(world, seeds, laboratory, jars, witness);
        }
    }

    /**
     * Runs a world to its goal, or to its end.
     *
     * @param room where nothing has happened yet
     * @param starter of bricks in that room
     */
    public static void run(
            World world, Seeds seeds, BrickRoom room, Starter starter, Witness witness) {
        new WorldRun(world, seeds, room, witness).run(starter);
    }

    private void run(Starter starter) {
        scene = physics.start();
        room.surround(Physics.STEP, this::step);
        for (int i = 0; i < bricks.length; i++) {
            room.runUntil(physics.switchedOn(i));
            bricks[i] = starter.start(world.robots().get(i));
            bricks[i].observe(witness.of(world.robots().get(i)));
            expose(i);
        }
        long end = world.seconds() * SECOND;
        long watch = world.goal() > 0 ? WATCH : SECOND;
        if (!isOver()) {
            room.runUntil(end, watch, this::isOver);
        }
        for (Brick brick : bricks) {
            brick.failure().ifPresent(reason -> witness.failed(brick.name(), reason));
            witness.noted(brick.name(), brick.notes());
        }
    }

    private boolean isOver() {
        boolean done = world.goal() > 0 && scene.delivered() >= world.goal();
        boolean running = false;
        for (Brick brick : bricks) {
            done |= brick.failure().isPresent();
            running |= brick.isRunning();
        }
        return done || !running;
    }

    /** A step of the world; the first one only shows the sensors what there is. */
    private void step() {
        if (room.time() > 0) {
            for (int i = 0; i < bricks.length; i++) {
                for (int m = 0; bricks[i] != null && m < MOTORS.length; m++) {
                    shafts[i][m] = bricks[i].speed(MOTORS[m]);
                }
            }
            scene = physics.step(scene, shafts);
        }
        for (int i = 0; i < bricks.length; i++) {
            if (bricks[i] != null) {
                expose(i);
            }
        }
        witness.see(scene, this);
    }

    /** Its sensors see the scene as it is, from now to the next step. */
    private void expose(int index) {
        List<Device.Sensor> own = sensors.get(index);
        for (int s = 0; s < own.size(); s++) {
            SensorName socket = SOCKETS[own.get(s).socket() - 1];
            bricks[index].expose(socket, sources.get(index).get(s));
        }
    }

    @Override
    public int[] readings(int robot) {
        return sensors.get(robot).stream()
                .mapToInt(sensor -> senses.read(scene, robot, sensor))
                .toArray();
    }

    @Override
    public String display(int robot) {
        Brick brick = bricks[robot];
        return brick == null ? "" : brick.row(0);
    }
}
