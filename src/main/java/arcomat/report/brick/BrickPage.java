package arcomat.report.brick;

import arcomat.report.finding.FindingsText;
import arcomat.report.page.Page;
import arcomat.report.page.Page.Tone;
import arcomat.report.page.Story;
import arcomat.report.page.Story.Remark;
import arcomat.report.page.Timeline;
import arcomat.report.page.Timeline.Flaw;
import arcomat.report.page.Track;
import arcomat.report.page.Track.Kind;
import arcomat.sim.device.MotorName;
import arcomat.sim.device.SensorName;
import arcomat.sim.trace.Lateness;
import arcomat.sim.trace.Trace;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.stream.Stream;

/** A program's run on a simulated brick as a page: cycle by cycle, in the brick's time. */
public final class BrickPage {
    private static final String OTHER = "what else happens";

    private BrickPage() {}

    /**
     * @param jar the program
     * @param ending how it ended, in words
     * @param failure what nothing in the program caught
     * @param lateness how often the program came late
     * @param screen what the display shows at the end
     */
    public static Page of(
            String jar,
            Trace trace,
            String ending,
            Optional<String> failure,
            Lateness lateness,
            List<String> screen) {
        BrickRows all = BrickRows.of(trace);
        int length = all.rows().size();
        List<Remark> remarks = new ArrayList<>();
        List<Flaw> flaws = new ArrayList<>();
        if (failure.isPresent()) {
            remarks.add(Remark.of(Tone.BAD, failure.get()).at(length - 1));
            flaws.add(new Flaw(length - 1, "", failure.get()));
        }
        if (lateness.slices() > 0) {
            remarks.add(Remark.of(Tone.OPEN, BrickTraceText.of(lateness)));
        }
        screen.forEach(row -> remarks.add(Remark.of(Tone.NEUTRAL, "display: " + row)));
        Timeline timeline =
                new Timeline(
                        "cycle",
                        length,
                        all.rows().stream().map(BrickRows.Row::time).toList(),
                        tracks(all),
                        flaws);
        Tone tone = failure.isPresent() ? Tone.BAD : Tone.NEUTRAL;
        return new Page(
                "run-brick",
                jar,
                tone,
                ending + " after " + FindingsText.count(length, "cycle"),
                List.of(new Story("", tone, "", remarks, timeline, List.of())));
    }

    private static List<Track> tracks(BrickRows all) {
        List<Track> tracks = new ArrayList<>();
        for (SensorName sensor : all.sensors()) {
            Stream<String> values = all.rows().stream().map(row -> row.value(sensor));
            tracks.add(Track.of("sensors", sensor.name(), Kind.VARIABLE, values));
        }
        for (MotorName motor : all.motors()) {
            Stream<String> orders = all.rows().stream().map(row -> row.order(motor));
            tracks.add(Track.of("motors", motor.name(), Kind.VARIABLE, orders));
        }
        Stream<String> others = all.rows().stream().map(BrickRows.Row::others);
        tracks.add(Track.of("brick", OTHER, Kind.PORT, others));
        return tracks;
    }
}
