package arcomat.report.world;

import arcomat.report.brick.BrickTraceText;
import arcomat.report.text.Printable;
import arcomat.report.text.Style;
import arcomat.report.text.TextTable;
import arcomat.sim.trace.Lateness;
import arcomat.world.Recording;
import arcomat.world.Recording.Event;
import arcomat.world.Scene.Happening;

import java.util.List;

/** A run of a world for people: what happened, and how it ended. */
public final class WorldText {
    private WorldText() {}

    /** A table of what happened, but for messages between robots. */
    public static String events(Recording recording, Style style) {
        TextTable table = new TextTable(List.of("s", "who", "what"));
        for (Event event : recording.events()) {
            if (event instanceof Event.Showed showed) {
                table.add(row(event, showed.robot(), showed.text()));
            } else if (event instanceof Event.Happened happened) {
                table.add(row(event, happened.happening().who(), told(happened.happening())));
            }
        }
        return table.render(style);
    }

    private static List<String> row(Event event, String who, String what) {
        return List.of(seconds(event.time()), who, Printable.escape(what));
    }

    private static String told(Happening happening) {
        String whom = happening.whom();
        return switch (happening.what()) {
            case COLLISION -> "runs into " + whom;
            case PUSH -> "pushes " + whom;
            case CUP_GIVEN -> "gets a cup from " + whom;
            case CUP_LOST -> "drops a cup on the floor";
            case COFFEE_POURED -> "gets coffee from " + whom;
            case COFFEE_SPILT -> "pours coffee on the floor";
            case COFFEE_TAKEN -> "brings coffee to " + whom;
        };
    }

    private static String seconds(int milliseconds) {
        int tenths = (milliseconds + 50) / 100;
        return tenths / 10 + "." + tenths % 10;
    }

    /** How long it took and what came of it; below that line, what may be a fault of the world. */
    public static String summary(Recording recording) {
        StringBuilder text = new StringBuilder(seconds(recording.duration())).append(" s");
        long collisions = recording.count(Happening.What.COLLISION);
        text.append(collisions == 0 ? ", no collision" : ", " + number(collisions, "collision"));
        int goal = recording.world().goal();
        if (goal > 0) {
            text.append(", ").append(recording.delivered()).append(" of ");
            text.append(number(goal, "cup")).append(" delivered");
        }
        recording
                .failures()
                .forEach(
                        (robot, reason) ->
                                text.append("\nthe program of ")
                                        .append(robot)
                                        .append(" failed: ")
                                        .append(Printable.escape(reason)));
        for (Recording.Blind each : recording.blind()) {
            text.append("\nthe program of ").append(each.robot()).append(" reads S");
            text.append(each.socket());
            text.append(
                    each.sensor()
                            .map(as -> " as " + as + ", and the robot has another sensor there")
                            .orElse(", where the robot has no sensor"));
        }
        for (Recording.Late each : recording.late()) {
            text.append("\nof ").append(each.robot()).append(", ");
            text.append(BrickTraceText.of(new Lateness(each.slices(), each.longest())));
        }
        recording
                .stillSince()
                .ifPresent(
                        since ->
                                text.append("\nnobody has moved since ")
                                        .append(seconds(since))
                                        .append(" s"));
        return text.toString();
    }

    private static String number(long number, String what) {
        return number + " " + what + (number == 1 ? "" : "s");
    }
}
