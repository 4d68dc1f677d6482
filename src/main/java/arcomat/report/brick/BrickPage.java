package arcomat.report.brick;

import arcomat.report.finding.FindingsText;
import arcomat.report.page.Page;
import arcomat.report.page.Page.Tone;
import arcomat.report.page.Story;
import arcomat.report.page.Story.Fact;
import arcomat.report.page.Story.Remark;
import arcomat.report.page.Timeline;
import arcomat.report.page.Timeline.Flaw;
import arcomat.report.page.Track;
import arcomat.report.page.Track.Kind;
import arcomat.report.run.RunDrawings;
import arcomat.report.run.TracePage;
import arcomat.sim.device.MotorName;
import arcomat.sim.device.SensorName;
import arcomat.sim.trace.Lateness;
import arcomat.sim.trace.Trace;
import arcomat.simulate.run.RobotRun;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.stream.Stream;

/**
 * A program's run on a simulated brick as a page: cycle by cycle, in the brick's time; below what
 * the brick sees, what the parts of its model do, at the same cursor.
 */
public final class BrickPage {
    private static final String OTHER = "what else happens";

    private BrickPage() {}

    /**
     * @param jar the program
     * @param ending how it ended, in words
     * @param failure what nothing in the program caught
     * @param lateness how often the program came late
     * @param screen what the display shows at the end
     * @param inside what the model did that the program was made of, where that is known
     */
    public static Page of(
            String jar,
            Trace trace,
            String ending,
            Optional<String> failure,
            Lateness lateness,
            List<String> screen,
            Optional<RobotRun> inside) {
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
        List<Long> times = all.rows().stream().map(BrickRows.Row::time).toList();
        Optional<Story> model = inside.map(BrickPage::story);
        List<Track> tracks = new ArrayList<>(tracks(all));
        model.ifPresent(told -> tracks.addAll(CycleSteps.of(times, told.timeline())));
        Timeline timeline = new Timeline("cycle", length, times, tracks, flaws);
        List<Story.Drawing> drawings = model.map(Story::drawings).orElse(List.of());
        Tone tone = failure.isPresent() ? Tone.BAD : Tone.NEUTRAL;
        return new Page(
                "run-brick",
                jar,
                tone,
                ending + " after " + FindingsText.count(length, "cycle"),
                List.of(
                        new Story("", tone, "", remarks, timeline, drawings)
                                .telling(facts(jar, inside))));
    }

    private static Story story(RobotRun run) {
        return TracePage.story("", run.trace(), run.times(), new RunDrawings());
    }

    private static List<Fact> facts(String jar, Optional<RobotRun> inside) {
        return List.of(
                Fact.of("asked", "what %s does on a simulated brick", jar),
                inside.map(
                                run ->
                                        Fact.of(
                                                "inside",
                                                "what %s does, of which the program was made; a"
                                                    + " slice belongs to the cycle that it begins"
                                                    + " in",
                                                run.trace().component().qualifiedName()))
                        .orElse(
                                new Fact(
                                        "next",
                                        "'--models PATH', the models that the program was made of,"
                                                + " shows here what its parts and automata do")));
    }

    /** Called as nothing in a model can be called. */
    private static List<Track> tracks(BrickRows all) {
        List<Track> tracks = new ArrayList<>();
        for (SensorName sensor : all.sensors()) {
            Stream<String> values = all.rows().stream().map(row -> row.value(sensor));
            tracks.add(Track.of("sensors", "sensor " + sensor.name(), Kind.VARIABLE, values));
        }
        for (MotorName motor : all.motors()) {
            Stream<String> orders = all.rows().stream().map(row -> row.order(motor));
            tracks.add(Track.of("motors", "motor " + motor.name(), Kind.VARIABLE, orders));
        }
        Stream<String> others = all.rows().stream().map(BrickRows.Row::others);
        tracks.add(Track.of("brick", OTHER, Kind.PORT, others));
        return tracks;
    }
}
