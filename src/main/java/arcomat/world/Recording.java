package arcomat.world;

import arcomat.world.Scene.DrinkerState;

import java.util.List;
import java.util.Map;

/**
 * What happened in a world: enough to show it again, without running anything.
 *
 * @param seed of what was drawn
 * @param frames the world every {@value #PERIOD} milliseconds
 * @param events what people would tell of, in the order of time
 * @param failures why programs stopped, by robot
 */
public record Recording(
        World world,
        long seed,
        List<Frame> frames,
        List<Event> events,
        Map<String, String> failures) {
    /** From one frame to the next, in milliseconds. */
    public static final int PERIOD = 100;

    public Recording {
        frames = List.copyOf(frames);
        events = List.copyOf(events);
        failures = Map.copyOf(failures);
    }

    /**
     * The world at a moment.
     *
     * @param time in milliseconds
     */
    public record Frame(int time, List<RobotFrame> robots, List<DrinkerState> drinkers) {
        public Frame {
            robots = List.copyOf(robots);
            drinkers = List.copyOf(drinkers);
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

        /** In the world. */
        record Happened(int time, Happening happening) implements Event {}

        /** A robot shows another text on the first row of its display. */
        record Showed(int time, String robot, String text) implements Event {}

        /** A robot has sent a packet over Bluetooth; its bytes in hexadecimal. */
        record Sent(int time, String robot, String bytes) implements Event {}
    }

    /** Milliseconds from the first frame to the last, or to the last event. */
    public int duration() {
        int seen = frames.isEmpty() ? 0 : frames.get(frames.size() - 1).time();
        return events.isEmpty() ? seen : Math.max(seen, events.get(events.size() - 1).time());
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
