package arcomat.report.world;

import arcomat.report.text.Json;
import arcomat.world.Device;
import arcomat.world.Point;
import arcomat.world.Recording;
import arcomat.world.Scene.Happening;
import arcomat.world.Segment;

import java.util.Iterator;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.stream.Stream;

/**
 * A recording for programs. Places are in mm, angles in degrees, times in milliseconds; numbers are
 * rounded to what can be seen.
 *
 * @param frames made one by one, because there are many
 * @param failures why programs stopped, by robots
 */
public record WorldJson(
        long seed,
        int period,
        World world,
        Iterator<Frame> frames,
        List<Event> events,
        Map<String, String> failures) {
    private static final double TENTHS = 10;

    /**
     * The floor.
     *
     * @param walls points of each: x, y, x, y
     */
    record World(
            double width,
            double depth,
            int goal,
            List<Line> lines,
            List<List<Double>> walls,
            List<Robot> robots,
            List<Drinker> drinkers) {
        static World of(arcomat.world.World world) {
            return new World(
                    rounded(world.width()),
                    rounded(world.depth()),
                    world.goal(),
                    world.lines().stream().map(Line::of).toList(),
                    world.walls().stream().map(wall -> points(List.of(wall))).toList(),
                    world.robots().stream().map(Robot::of).toList(),
                    world.drinkers().stream()
                            .map(each -> Drinker.of(each.name(), each.spot()))
                            .toList());
        }
    }

    record Line(double width, List<Double> points) {
        static Line of(arcomat.world.World.Line line) {
            return new Line(rounded(line.width()), WorldJson.points(line.pieces()));
        }
    }

    record Drinker(String name, double x, double y) {
        static Drinker of(String name, Point spot) {
            return new Drinker(name, rounded(spot.x()), rounded(spot.y()));
        }
    }

    record Robot(
            String name,
            String kind,
            String program,
            double radius,
            boolean moves,
            List<Sensor> sensors) {
        static Robot of(arcomat.world.World.Robot robot) {
            return new Robot(
                    robot.name(),
                    robot.kind().name(),
                    robot.kind().program().name(),
                    rounded(robot.kind().radius()),
                    robot.kind().wheels().isPresent(),
                    robot.kind().sensors().stream().map(Sensor::of).toList());
        }
    }

    /** A sensor; where a holder is shows in its cup. */
    record Sensor(
            String socket,
            String type,
            Optional<Double> x,
            Optional<Double> y,
            Optional<Double> facing) {
        static Sensor of(Device.Sensor sensor) {
            Optional<Point> place =
                    sensor instanceof Device.Placed placed && !(sensor instanceof Device.Holder)
                            ? Optional.of(placed.place())
                            : Optional.empty();
            return new Sensor(
                    "S" + sensor.socket(),
                    sensor.getClass().getSimpleName().toLowerCase(Locale.ROOT),
                    place.map(at -> rounded(at.x())),
                    place.map(at -> rounded(at.y())),
                    sensor instanceof Device.Ultrasonic ultrasonic
                            ? Optional.of(rounded(Math.toDegrees(ultrasonic.facing())))
                            : Optional.empty());
        }
    }

    /**
     * A moment.
     *
     * @param t when
     * @param robots {@code [x, y, heading, left, right, cup, [readings], display, stock, brewing]}
     * @param drinkers {@code [present, cups]}
     */
    record Frame(int t, List<List<Object>> robots, List<List<Object>> drinkers) {
        static Frame of(Recording.Frame frame) {
            return new Frame(
                    frame.time(),
                    frame.robots().stream().map(Frame::of).toList(),
                    frame.drinkers().stream()
                            .map(each -> List.<Object>of(each.present(), each.cups()))
                            .toList());
        }

        private static List<Object> of(Recording.RobotFrame robot) {
            return List.of(
                    rounded(robot.pose().x()),
                    rounded(robot.pose().y()),
                    rounded(Math.toDegrees(robot.pose().heading())),
                    Math.round(robot.left()),
                    Math.round(robot.right()),
                    robot.cup().ordinal(),
                    robot.sensors(),
                    robot.display(),
                    robot.stock(),
                    robot.brewing());
        }
    }

    /** Something that happened between two, or that one has shown or sent. */
    record Event(int t, String what, String who, Optional<String> whom, Optional<String> text) {
        static Event of(Recording.Event event) {
            if (event instanceof Recording.Event.Happened happened) {
                Happening happening = happened.happening();
                return new Event(
                        event.time(),
                        happening.what().name(),
                        happening.who(),
                        Optional.of(happening.whom()),
                        Optional.empty());
            }
            if (event instanceof Recording.Event.Showed showed) {
                return of(event, "SHOWED", showed.robot(), showed.text());
            }
            Recording.Event.Sent sent = (Recording.Event.Sent) event;
            return of(event, "SENT", sent.robot(), sent.bytes());
        }

        private static Event of(Recording.Event event, String what, String who, String text) {
            return new Event(event.time(), what, who, Optional.empty(), Optional.of(text));
        }
    }

    public static String render(Recording recording) {
        Map<String, String> failures = new LinkedHashMap<>();
        recording.world().robots().stream()
                .map(arcomat.world.World.Robot::name)
                .filter(recording.failures()::containsKey)
                .forEach(name -> failures.put(name, recording.failures().get(name)));
        return Json.compact(
                new WorldJson(
                        recording.seed(),
                        Recording.PERIOD,
                        World.of(recording.world()),
                        recording.frames().stream().map(Frame::of).iterator(),
                        recording.events().stream().map(Event::of).toList(),
                        failures));
    }

    /** Points of a chain of segments: x, y, x, y. */
    private static List<Double> points(List<Segment> pieces) {
        return Stream.concat(Stream.of(pieces.get(0).from()), pieces.stream().map(Segment::to))
                .flatMap(point -> Stream.of(rounded(point.x()), rounded(point.y())))
                .toList();
    }

    private static double rounded(double value) {
        return Math.round(value * TENTHS) / TENTHS;
    }
}
