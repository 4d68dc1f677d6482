package arcomat.report.world;

import arcomat.report.finding.FindingsJson;
import arcomat.report.text.Json;
import arcomat.source.Diagnostic;
import arcomat.world.Physics;
import arcomat.world.Recording;
import arcomat.world.Scene.Happening;
import arcomat.world.Seeds;

import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.TreeMap;

/**
 * A run of a world for programs: what happened, and how it ended. Times are in milliseconds.
 *
 * @param then other seeds from some moments on
 * @param delivered cups that drinkers have taken
 * @param goal how many they should take
 * @param failures why programs stopped, by robot
 * @param blind sockets that programs have read, and in which their robots have no such sensor
 * @param late robots whose slices took too long
 * @param stillSince when the last robot has moved, where none will any more
 * @param findings warnings about the world and its models
 */
public record WorldRunJson(
        String world,
        long seed,
        Optional<List<Change>> then,
        int duration,
        boolean succeeded,
        long collisions,
        int delivered,
        int goal,
        List<Event> events,
        Map<String, String> failures,
        List<Recording.Blind> blind,
        List<Recording.Late> late,
        Optional<Integer> stillSince,
        List<FindingsJson.Finding> findings) {

    record Change(long from, long seed) {
        static Optional<List<Change>> all(Seeds seeds) {
            return Optional.of(seeds.changes())
                    .filter(changes -> !changes.isEmpty())
                    .map(changes -> changes.stream().map(Change::of).toList());
        }

        private static Change of(Seeds.Change change) {
            return new Change(change.tick() * Physics.STEP, change.seed());
        }
    }

    /**
     * Something that happened.
     *
     * @param what {@code SHOWED}, {@code SENT}, or what happened in the world
     * @param whom with or by whom
     * @param text on a display, or bytes of a packet in hexadecimal
     */
    record Event(int t, String what, String who, Optional<String> whom, Optional<String> text) {
        static Event of(Recording.Event event) {
            return event.match(
                    happened -> of(happened.time(), happened.happening()),
                    showed -> said(showed.time(), "SHOWED", showed.robot(), showed.text()),
                    sent -> said(sent.time(), "SENT", sent.robot(), sent.bytes()));
        }

        private static Event of(int time, Happening happening) {
            Optional<String> whom = Optional.of(happening.whom()).filter(name -> !name.isEmpty());
            return new Event(
                    time, happening.what().name(), happening.who(), whom, Optional.empty());
        }

        private static Event said(int time, String what, String who, String text) {
            return new Event(time, what, who, Optional.empty(), Optional.of(text));
        }
    }

    /**
     * @param world its file, as the user wrote it
     * @param findings that did not keep it from running
     */
    public static String render(String world, Recording recording, List<Diagnostic> findings) {
        return Json.text(
                new WorldRunJson(
                        world,
                        recording.seeds().first(),
                        Change.all(recording.seeds()),
                        recording.duration(),
                        recording.succeeded(),
                        recording.count(Happening.What.COLLISION),
                        recording.delivered(),
                        recording.world().goal(),
                        recording.events().stream().map(Event::of).toList(),
                        new TreeMap<>(recording.failures()),
                        recording.blind(),
                        recording.late(),
                        recording.stillSince().stream().boxed().findFirst(),
                        FindingsJson.Finding.all(findings)));
    }
}
