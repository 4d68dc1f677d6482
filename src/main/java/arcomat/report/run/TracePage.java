package arcomat.report.run;

import arcomat.model.Component;
import arcomat.model.Trace;
import arcomat.report.finding.FindingsText;
import arcomat.report.page.Page;
import arcomat.report.page.Page.Tone;
import arcomat.report.page.Story;
import arcomat.report.page.Story.Fact;
import arcomat.report.page.Story.Remark;
import arcomat.report.page.Timeline;
import arcomat.report.page.Timeline.Flaw;
import arcomat.simulate.watch.Watch.Violation;
import arcomat.simulate.watch.Watching.Watched;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;

/** A run of a model as a page: what came in, what was to be seen, where each automaton was. */
public final class TracePage {
    private TracePage() {}

    public static Page of(Trace trace, List<Watched> watched) {
        return of(trace, watched, "");
    }

    /**
     * @param how what came in and who chose, in words; empty where nobody says
     */
    public static Page of(Trace trace, List<Watched> watched, String how) {
        TraceTracks tracks = new TraceTracks(trace);
        List<Remark> remarks = new ArrayList<>();
        List<Flaw> flaws = new ArrayList<>();
        for (Watched each : watched) {
            remarks.add(remark(each, tracks.unit()));
            each.violation().ifPresent(v -> flaws.add(new Flaw(v.slice(), "", v.message())));
        }
        int length = tracks.length();
        if (trace.failure().isPresent() && length > 0) {
            flaws.add(new Flaw(length - 1, "", "stopped: " + trace.failure().get()));
        }
        Timeline timeline = new Timeline(tracks.unit(), length, List.of(), tracks.all(), flaws);
        Story story =
                new Story(
                                "",
                                Tone.NEUTRAL,
                                "",
                                remarks,
                                timeline,
                                tracks.drawings(new RunDrawings()))
                        .telling(facts(trace, how));
        return new Page(
                "simulate",
                trace.component().qualifiedName(),
                tone(trace, watched),
                headline(trace, watched, tracks.unit()),
                List.of(story));
    }

    private static List<Fact> facts(Trace trace, String how) {
        List<Fact> facts = new ArrayList<>();
        if (!how.isEmpty()) {
            facts.add(new Fact("asked", how));
        }
        facts.add(RunFacts.time(trace.component()));
        RunFacts.completions(trace.component(), trace.component().automata()).ifPresent(facts::add);
        facts.add(
                new Fact(
                        "next",
                        "'--record FILE.mt' keeps the run as a stream test; '--choose ask' lets"
                                + " you choose where the model leaves something open"));
        return facts;
    }

    /**
     * What a robot's program did, with nothing to be said about it but that. Where events drive it,
     * a step is all that it handles in a cycle.
     *
     * @param times of its steps, in milliseconds
     */
    public static Story story(String title, Trace trace, List<Long> times, RunDrawings pictures) {
        TraceTracks tracks = new TraceTracks(trace);
        boolean events = trace.component().profile() == Component.Profile.EVENT_DRIVEN;
        Timeline timeline =
                new Timeline(
                        events ? "cycle" : tracks.unit(),
                        tracks.length(),
                        times,
                        tracks.all(),
                        List.of());
        return new Story(title, Tone.NEUTRAL, "", List.of(), timeline, tracks.drawings(pictures));
    }

    private static Tone tone(Trace trace, List<Watched> watched) {
        if (trace.failure().isPresent()
                || watched.stream().anyMatch(each -> each.violation().isPresent())) {
            return Tone.BAD;
        }
        return watched.isEmpty() ? Tone.NEUTRAL : unknown(watched) > 0 ? Tone.OPEN : Tone.GOOD;
    }

    private static long unknown(List<Watched> watched) {
        return watched.stream().filter(each -> each.unknown().isPresent()).count();
    }

    private static String headline(Trace trace, List<Watched> watched, String unit) {
        String length = FindingsText.count(trace.steps().size(), unit);
        if (trace.failure().isPresent()) {
            return "stopped after " + length + ": " + trace.failure().get();
        }
        long violated = watched.stream().filter(each -> each.violation().isPresent()).count();
        if (violated > 0) {
            return length + "; " + FindingsText.count(violated, "requirement") + " violated";
        }
        if (unknown(watched) > 0) {
            return length + "; unknown: " + FindingsText.count(unknown(watched), "requirement");
        }
        return watched.isEmpty() ? length : length + "; all that was watched is kept";
    }

    private static Remark remark(Watched watched, String unit) {
        Optional<Violation> violation = watched.violation();
        if (violation.isPresent()) {
            return Remark.of(Tone.BAD, "violated: " + violation.get().message())
                    .about(violation.get().requirement().span())
                    .at(violation.get().slice());
        }
        if (watched.unknown().isPresent()) {
            String text = "unknown whether %s is kept: %s";
            return Remark.of(
                    Tone.OPEN, text.formatted(watched.requirement(), watched.unknown().get()));
        }
        if (watched.nothingFrom().isPresent()) {
            int from = watched.nothingFrom().getAsInt();
            String text = "%s is kept, but promises nothing from %s %d on";
            return Remark.of(Tone.OPEN, text.formatted(watched.requirement(), unit, from)).at(from);
        }
        return Remark.of(Tone.GOOD, watched.requirement() + " is kept");
    }
}
