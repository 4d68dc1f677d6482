package arcomat.report.world;

import arcomat.report.text.Json;
import arcomat.world.Device;
import arcomat.world.Point;
import arcomat.world.Recording;
import arcomat.world.Recording.Event;
import arcomat.world.Recording.Frame;
import arcomat.world.Recording.RobotFrame;
import arcomat.world.Scene.DrinkerState;
import arcomat.world.Scene.Happening;
import arcomat.world.Segment;
import arcomat.world.World;
import arcomat.world.World.Robot;

import com.fasterxml.jackson.core.JsonGenerator;

import java.io.IOException;
import java.util.List;

/**
 * A recording for programs. Places are in mm, angles in degrees, times in milliseconds; numbers are
 * rounded to what can be seen. A frame is an array per robot, because there are many.
 */
public final class WorldJson {
    private static final double TENTHS = 10;

    private final JsonGenerator json;

    private WorldJson(JsonGenerator json) {
        this.json = json;
    }

    public static String render(Recording recording) {
        return Json.compact(json -> new WorldJson(json).write(recording));
    }

    private void write(Recording recording) throws IOException {
        json.writeStartObject();
        json.writeNumberField("seed", recording.seed());
        json.writeNumberField("period", Recording.PERIOD);
        json.writeFieldName("world");
        world(recording.world());
        json.writeArrayFieldStart("frames");
        for (Frame frame : recording.frames()) {
            frame(frame);
        }
        json.writeEndArray();
        json.writeArrayFieldStart("events");
        for (Event event : recording.events()) {
            event(event);
        }
        json.writeEndArray();
        json.writeObjectFieldStart("failures");
        for (Robot robot : recording.world().robots()) {
            String reason = recording.failures().get(robot.name());
            if (reason != null) {
                json.writeStringField(robot.name(), reason);
            }
        }
        json.writeEndObject();
        json.writeEndObject();
    }

    private void world(World world) throws IOException {
        json.writeStartObject();
        number("width", world.width());
        number("depth", world.depth());
        json.writeNumberField("goal", world.goal());
        json.writeArrayFieldStart("lines");
        for (World.Line line : world.lines()) {
            json.writeStartObject();
            number("width", line.width());
            json.writeFieldName("points");
            outline(line.pieces());
            json.writeEndObject();
        }
        json.writeEndArray();
        json.writeArrayFieldStart("walls");
        for (Segment wall : world.walls()) {
            outline(List.of(wall));
        }
        json.writeEndArray();
        json.writeArrayFieldStart("robots");
        for (Robot robot : world.robots()) {
            robot(robot);
        }
        json.writeEndArray();
        json.writeArrayFieldStart("drinkers");
        for (var drinker : world.drinkers()) {
            json.writeStartObject();
            json.writeStringField("name", drinker.name());
            number("x", drinker.spot().x());
            number("y", drinker.spot().y());
            json.writeEndObject();
        }
        json.writeEndArray();
        json.writeEndObject();
    }

    /** Points of a chain of segments: x, y, x, y. */
    private void outline(List<Segment> pieces) throws IOException {
        json.writeStartArray();
        point(pieces.get(0).from());
        for (Segment piece : pieces) {
            point(piece.to());
        }
        json.writeEndArray();
    }

    private void point(Point point) throws IOException {
        json.writeNumber(rounded(point.x()));
        json.writeNumber(rounded(point.y()));
    }

    private void robot(Robot robot) throws IOException {
        json.writeStartObject();
        json.writeStringField("name", robot.name());
        json.writeStringField("kind", robot.kind().name());
        json.writeStringField("program", robot.kind().program().name());
        number("radius", robot.kind().radius());
        json.writeBooleanField("moves", robot.kind().wheels().isPresent());
        json.writeArrayFieldStart("sensors");
        for (Device.Sensor sensor : robot.kind().sensors()) {
            sensor(sensor);
        }
        json.writeEndArray();
        json.writeEndObject();
    }

    private void sensor(Device.Sensor sensor) throws IOException {
        json.writeStartObject();
        json.writeStringField("socket", "S" + sensor.socket());
        json.writeStringField(
                "type", sensor.getClass().getSimpleName().toLowerCase(java.util.Locale.ROOT));
        // Where a holder is shows in its cup.
        if (sensor instanceof Device.Placed placed && !(sensor instanceof Device.Holder)) {
            number("x", placed.place().x());
            number("y", placed.place().y());
        }
        if (sensor instanceof Device.Ultrasonic ultrasonic) {
            number("facing", Math.toDegrees(ultrasonic.facing()));
        }
        json.writeEndObject();
    }

    /**
     * {@code {"t", "robots": [[x, y, heading, left, right, cup, [readings], display, stock,
     * brewing]]}}.
     */
    private void frame(Frame frame) throws IOException {
        json.writeStartObject();
        json.writeNumberField("t", frame.time());
        json.writeArrayFieldStart("robots");
        for (RobotFrame robot : frame.robots()) {
            json.writeStartArray();
            json.writeNumber(rounded(robot.pose().x()));
            json.writeNumber(rounded(robot.pose().y()));
            json.writeNumber(rounded(Math.toDegrees(robot.pose().heading())));
            json.writeNumber(Math.round(robot.left()));
            json.writeNumber(Math.round(robot.right()));
            json.writeNumber(robot.cup().ordinal());
            json.writeStartArray();
            for (int reading : robot.sensors()) {
                json.writeNumber(reading);
            }
            json.writeEndArray();
            json.writeString(robot.display());
            json.writeNumber(robot.stock());
            json.writeBoolean(robot.brewing());
            json.writeEndArray();
        }
        json.writeEndArray();
        json.writeArrayFieldStart("drinkers");
        for (DrinkerState drinker : frame.drinkers()) {
            json.writeStartArray();
            json.writeBoolean(drinker.present());
            json.writeNumber(drinker.cups());
            json.writeEndArray();
        }
        json.writeEndArray();
        json.writeEndObject();
    }

    private void event(Event event) throws IOException {
        json.writeStartObject();
        json.writeNumberField("t", event.time());
        if (event instanceof Event.Happened happened) {
            Happening happening = happened.happening();
            json.writeStringField("what", happening.what().name());
            json.writeStringField("who", happening.who());
            json.writeStringField("whom", happening.whom());
        } else if (event instanceof Event.Showed showed) {
            json.writeStringField("what", "SHOWED");
            json.writeStringField("who", showed.robot());
            json.writeStringField("text", showed.text());
        } else if (event instanceof Event.Sent sent) {
            json.writeStringField("what", "SENT");
            json.writeStringField("who", sent.robot());
            json.writeStringField("text", sent.bytes());
        }
        json.writeEndObject();
    }

    private void number(String name, double value) throws IOException {
        json.writeNumberField(name, rounded(value));
    }

    private static double rounded(double value) {
        return Math.round(value * TENTHS) / TENTHS;
    }
}
