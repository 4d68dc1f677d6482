package arcomat.report.world;

import arcomat.report.text.Fields;
import arcomat.report.text.Json;
import arcomat.world.Device;
import arcomat.world.Physics;
import arcomat.world.Point;
import arcomat.world.Recording;
import arcomat.world.Recording.Event;
import arcomat.world.Recording.Frame;
import arcomat.world.Recording.RobotFrame;
import arcomat.world.Scene.Happening;
import arcomat.world.Seeds;
import arcomat.world.Segment;
import arcomat.world.World;
import arcomat.world.World.Robot;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.stream.Stream;

/**
 * A recording for programs, in the form that the page's {@code recording.js} reads. Places are in
 * mm, angles in degrees, times in milliseconds; numbers are rounded to what can be seen. A frame is
 * an array per robot, because there are many.
 */
public final class WorldJson {
    private static final double TENTHS = 10;

    /** By this, and not by way of Java's function, it is the same in a browser. */
    private static final double DEGREES = 180 / Math.PI;

    private WorldJson() {}

    public static String render(Recording recording) {
        return Json.compact(fields(recording));
    }

    /** The same before it is a text; its values are numbers, texts, lists and maps of these. */
    public static Fields fields(Recording recording) {
        return fields(recording, PacketWords.of(List.of()), Optional.empty());
    }

    /**
     * @param words what packets mean
     * @param ghost another run to be shown beside it
     */
    static String render(Recording recording, PacketWords words, Optional<Ghost> ghost) {
        return Json.compact(fields(recording, words, ghost));
    }

    private static Fields fields(Recording recording, PacketWords words, Optional<Ghost> ghost) {
        Fields failures = new Fields();
        for (Robot robot : recording.world().robots()) {
            failures.with(
                    robot.name(), Optional.ofNullable(recording.failures().get(robot.name())));
        }
        return Fields.of("seed", recording.seeds().first())
                .with("then", then(recording.seeds()))
                .with("period", Recording.PERIOD)
                .with("world", world(recording.world()))
                .with("frames", recording.frames().stream().map(WorldJson::of).iterator())
                .with("events", recording.events().stream().map(each -> of(each, words)).toList())
                .with("failures", failures)
                .with("idle", idle(recording.idle()))
                .with("ghost", ghost.map(Ghost::json));
    }

    /**
     * {@code {"texts": [...], "parts": [{"robot", "part", "reasons": [t, text, t, text]}]}}: the
     * same reasons come again and again, and are told by their numbers.
     */
    private static Optional<Fields> idle(List<Recording.Idle> idle) {
        Map<String, Integer> texts = new LinkedHashMap<>();
        List<Fields> parts = new ArrayList<>();
        for (Recording.Idle each : idle) {
            List<Integer> reasons = new ArrayList<>();
            for (Recording.Reason reason : each.reasons()) {
                reasons.add(reason.time());
                reasons.add(texts.computeIfAbsent(reason.words(), any -> texts.size()));
            }
            if (!reasons.isEmpty()) {
                parts.add(
                        Fields.of("robot", each.robot())
                                .with("part", each.part())
                                .with("reasons", reasons));
            }
        }
        return parts.isEmpty()
                ? Optional.empty()
                : Optional.of(Fields.of("texts", List.copyOf(texts.keySet())).with("parts", parts));
    }

    /** Other seeds from some moments on; absent where there are none. */
    private static Optional<List<Fields>> then(Seeds seeds) {
        return some(seeds.changes().stream().map(WorldJson::of).toList());
    }

    private static Fields of(Seeds.Change change) {
        return Fields.of("from", change.tick() * Physics.STEP).with("seed", change.seed());
    }

    private static Fields world(World world) {
        return Fields.of("width", rounded(world.width()))
                .with("depth", rounded(world.depth()))
                .with("goal", world.goal())
                .with("lines", world.lines().stream().map(WorldJson::of).toList())
                .with("walls", world.walls().stream().map(w -> points(List.of(w))).toList())
                .with("robots", world.robots().stream().map(WorldJson::of).toList())
                .with(
                        "drinkers",
                        world.drinkers().stream()
                                .map(each -> at(Fields.of("name", each.name()), each.spot()))
                                .toList())
                .with("things", some(world.things().stream().map(WorldJson::of).toList()));
    }

    /** Absent where there are none. */
    private static <T> Optional<List<T>> some(List<T> all) {
        return Optional.of(all).filter(each -> !each.isEmpty());
    }

    private static Fields of(World.Thing thing) {
        return Fields.of("name", thing.name())
                .with("radius", rounded(thing.radius()))
                .with("mass", rounded(thing.mass()));
    }

    private static Fields of(World.Line line) {
        return Fields.of("width", rounded(line.width())).with("points", points(line.pieces()));
    }

    /** Points of a chain of segments: x, y, x, y. */
    private static List<Double> points(List<Segment> pieces) {
        Stream<Point> first = Stream.of(pieces.get(0).from());
        return Stream.concat(first, pieces.stream().map(Segment::to))
                .flatMap(point -> Stream.of(rounded(point.x()), rounded(point.y())))
                .toList();
    }

    private static Fields at(Fields thing, Point place) {
        return thing.with("x", rounded(place.x())).with("y", rounded(place.y()));
    }

    private static Fields of(Robot robot) {
        return Fields.of("name", robot.name())
                .with("kind", robot.kind().name())
                .with("program", robot.kind().program().name())
                .with("radius", rounded(robot.kind().radius()))
                .with("moves", robot.kind().wheels().isPresent())
                .with("sensors", robot.kind().sensors().stream().map(WorldJson::of).toList());
    }

    private static Fields of(Device.Sensor sensor) {
        String type = sensor.getClass().getSimpleName().toLowerCase(Locale.ROOT);
        Fields fields = Fields.of("socket", "S" + sensor.socket()).with("type", type);
        shownAt(sensor).ifPresent(place -> at(fields, place));
        if (sensor instanceof Device.Ultrasonic ultrasonic) {
            fields.with("facing", rounded(ultrasonic.facing() * DEGREES));
        }
        return fields;
    }

    /** Where a holder is shows in its cup. */
    private static Optional<Point> shownAt(Device.Sensor sensor) {
        return sensor instanceof Device.Placed placed && !(sensor instanceof Device.Holder)
                ? Optional.of(placed.place())
                : Optional.empty();
    }

    /**
     * {@code {"t", "robots": [[x, y, heading, left, right, cup, [readings], display, stock,
     * brewing]], "drinkers": [[present, cups]], "things": [[x, y]]}}.
     */
    private static Fields of(Frame frame) {
        return Fields.of("t", frame.time())
                .with("robots", frame.robots().stream().map(WorldJson::of).toList())
                .with(
                        "drinkers",
                        frame.drinkers().stream()
                                .map(each -> List.of(each.present(), each.cups()))
                                .toList())
                .with("things", some(frame.things().stream().map(WorldJson::place).toList()));
    }

    private static List<Double> place(Point point) {
        return List.of(rounded(point.x()), rounded(point.y()));
    }

    private static List<Object> of(RobotFrame robot) {
        return List.of(
                rounded(robot.pose().x()),
                rounded(robot.pose().y()),
                rounded(robot.pose().heading() * DEGREES),
                whole(robot.left()),
                whole(robot.right()),
                robot.cup().ordinal(),
                robot.sensors(),
                robot.display(),
                robot.stock(),
                robot.brewing());
    }

    private static Fields of(Event event, PacketWords words) {
        Fields fields = Fields.of("t", event.time());
        return event.match(
                happened -> {
                    Happening happening = happened.happening();
                    return fields.with("what", happening.what().name())
                            .with("who", happening.who())
                            .with("whom", happening.whom());
                },
                showed ->
                        fields.with("what", "SHOWED")
                                .with("who", showed.robot())
                                .with("text", showed.text()),
                sent ->
                        fields.with("what", "SENT")
                                .with("who", sent.robot())
                                .with("text", sent.bytes())
                                .with("words", words.of(sent.robot(), sent.bytes())));
    }

    private static double rounded(double value) {
        return whole(value * TENTHS) / TENTHS;
    }

    /** As a browser computes it, too: it has another idea of what lies half-way below 0. */
    private static long whole(double value) {
        return (long) Math.floor(value + 0.5);
    }
}
