package arcomat.world;

import arcomat.world.Scene.DrinkerState;
import arcomat.world.Scene.Happening;
import arcomat.world.World.Cup;

import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalInt;
import java.util.function.Function;
import java.util.stream.IntStream;

/**
 * What happened in a world: enough to show it again, without running anything.
 *
 * @param seeds of what was drawn
 * @param frames the world every {@value #PERIOD} milliseconds
 * @param events what people would tell of, in the order of time
 * @param failures why programs stopped, by robot
 * @param blind sockets that programs have read, and in which their robots have no such sensor
 * @param late robots whose slices took too long
 * @param idle why transitions did not fire; empty where nobody has asked
 */
public record Recording(
        World world,
        Seeds seeds,
        List<Frame> frames,
        List<Event> events,
        Map<String, String> failures,
        List<Blind> blind,
        List<Late> late,
        List<Idle> idle) {
    /** From one frame to the next, in milliseconds. */
    public static final int PERIOD = 100;

    /** So long, in milliseconds, no robot waits for another. */
    private static final int LONG = 10_000;

    public Recording {
        frames = List.copyOf(frames);
        events = List.copyOf(events);
        failures = Map.copyOf(failures);
        blind = List.copyOf(blind);
        late = List.copyOf(late);
        idle = List.copyOf(idle);
    }

    /**
     * A robot that came late.
     *
     * @param slices how often
     * @param longest microseconds that the longest of these slices took
     */
    public record Late(String robot, int slices, long longest) {
        /** The same robot, with its slices of before and of later. */
        Late and(Late later) {
            return new Late(robot, slices + later.slices, Math.max(longest, later.longest));
        }
    }

    /**
     * A socket that a program has read.
     *
     * @param socket from 1
     * @param sensor what the program takes it for; empty where the robot has no sensor at all
     */
    public record Blind(String robot, int socket, Optional<String> sensor) {}

    /**
     * What a part of a robot's program waits for.
     *
     * @param part its path; empty for the whole
     * @param reasons in the order of time; each holds until the next
     */
    public record Idle(String robot, String part, List<Reason> reasons) {
        public Idle {
            reasons = List.copyOf(reasons);
        }
    }

    /**
     * Why no transition of an automaton fires.
     *
     * @param time of the first slice, in milliseconds
     * @param words the transition that came nearest, and what it lacked; empty from where one fires
     */
    public record Reason(int time, String words) {}

    /**
     * The world at a moment.
     *
     * @param time in milliseconds
     * @param things where their middles are
     */
    public record Frame(
            int time, List<RobotFrame> robots, List<DrinkerState> drinkers, List<Point> things) {
        public Frame {
            robots = List.copyOf(robots);
            drinkers = List.copyOf(drinkers);
            things = List.copyOf(things);
        }
    }

    /**
     * A robot at a moment.
     *
     * @param left speed over the floor at the left wheel, in mm per second
     * @param right likewise
     * @param sensors readings in the order of the kind's sensors
     * @param display the first row of the brick's display
     * @param stock cups in its magazine
     * @param brewing whether its coffee machine works
     */
    public record RobotFrame(
            Pose pose,
            double left,
            double right,
            List<Integer> sensors,
            Cup cup,
            String display,
            int stock,
            boolean brewing) {
        public RobotFrame {
            sensors = List.copyOf(sensors);
        }
    }

    /** Something that happened at a moment, in milliseconds. */
    public sealed interface Event {
        int time();

        /** Takes the sum apart: one answer for each form. */
        <R> R match(
                Function<Happened, R> happened, Function<Showed, R> showed, Function<Sent, R> sent);

        /** In the world. */
        record Happened(int time, Happening happening) implements Event {
            @Override
            public <R> R match(
                    Function<Happened, R> happened,
                    Function<Showed, R> showed,
                    Function<Sent, R> sent) {
                return happened.apply(this);
            }
        }

        /** A robot shows another text on the first row of its display. */
        record Showed(int time, String robot, String text) implements Event {
            @Override
            public <R> R match(
                    Function<Happened, R> happened,
                    Function<Showed, R> showed,
                    Function<Sent, R> sent) {
                return showed.apply(this);
            }
        }

        /** A robot has sent a packet over Bluetooth; its bytes in hexadecimal. */
        record Sent(int time, String robot, String bytes) implements Event {
            @Override
            public <R> R match(
                    Function<Happened, R> happened,
                    Function<Showed, R> showed,
                    Function<Sent, R> sent) {
                return sent.apply(this);
            }
        }
    }

    /** Milliseconds from the first frame to the last, or to the last event. */
    public int duration() {
        int seen = frames.isEmpty() ? 0 : frames.get(frames.size() - 1).time();
        return events.isEmpty() ? seen : Math.max(seen, events.get(events.size() - 1).time());
    }

    /**
     * When the last robot has moved, in milliseconds, if none has for a long time and none will
     * reach anything any more; empty while they move, or have done what they should.
     */
    public OptionalInt stillSince() {
        int last = frames.size() - 1;
        while (last > 0 && !isMoving(frames.get(last - 1), frames.get(last))) {
            last--;
        }
        int since = frames.isEmpty() ? 0 : frames.get(Math.max(last, 0)).time();
        return stillSince(world, delivered(), duration(), since);
    }

    /**
     * @param delivered cups
     * @param duration of the run, in milliseconds
     * @param moved when a robot was last seen to move, in milliseconds
     */
    static OptionalInt stillSince(World world, int delivered, int duration, int moved) {
        boolean done = world.goal() > 0 && delivered >= world.goal();
        return done || duration - moved < LONG ? OptionalInt.empty() : OptionalInt.of(moved);
    }

    private static boolean isMoving(Frame before, Frame after) {
        return IntStream.range(0, after.robots().size())
                .anyMatch(i -> !after.robots().get(i).pose().equals(before.robots().get(i).pose()));
    }

    /** Cups that drinkers have taken. */
    public int delivered() {
        return (int) count(Happening.What.COFFEE_TAKEN);
    }

    /** How often something happened. */
    public long count(Happening.What what) {
        return events.stream()
                .filter(
                        event ->
                                event instanceof Event.Happened happened
                                        && happened.happening().what() == what)
                .count();
    }

    /** Whether everything went well: no collision, no program that failed, the goal reached. */
    public boolean succeeded() {
        return failures.isEmpty()
                && count(Happening.What.COLLISION) == 0
                && delivered() >= world.goal();
    }
}
