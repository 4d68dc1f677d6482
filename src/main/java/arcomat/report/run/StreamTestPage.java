package arcomat.report.run;

import arcomat.model.Component;
import arcomat.model.StreamTest;
import arcomat.model.Trace;
import arcomat.report.page.Page;
import arcomat.report.page.Page.Tone;
import arcomat.report.page.Story;
import arcomat.report.page.Story.Fact;
import arcomat.report.page.Story.Remark;
import arcomat.report.page.Timeline;
import arcomat.report.page.Timeline.Flaw;
import arcomat.report.page.Track;
import arcomat.report.page.Track.Kind;
import arcomat.report.text.Style;
import arcomat.simulate.test.StreamTestResult;
import arcomat.simulate.test.StreamTestResult.Cell;
import arcomat.simulate.test.StreamTestResult.Verdict;
import arcomat.simulate.test.StreamTests;

import java.util.ArrayList;
import java.util.List;
import java.util.Set;
import java.util.stream.Collectors;
import java.util.stream.Stream;

/** Stream tests as a page: what was expected beside what a run with first choices sends. */
public final class StreamTestPage {
    private static final String EXPECTED = " expected";

    private final StreamTestResult result;
    private final StreamTest test;
    private final Trace run;
    private final TraceTracks tracks;
    private final RunDrawings pictures;

    private StreamTestPage(StreamTestResult result, RunDrawings pictures) {
        this.result = result;
        this.pictures = pictures;
        test = result.test();
        run = StreamTests.firstRun(test, true);
        tracks = new TraceTracks(run);
    }

    public static Page of(String title, List<StreamTestResult> results) {
        RunDrawings pictures = new RunDrawings();
        List<Story> stories =
                results.stream().map(each -> new StreamTestPage(each, pictures).story()).toList();
        String headline = StreamTestText.summary(results, Style.PLAIN);
        return new Page("test", title, tone(results), headline, stories);
    }

    private static Tone tone(List<StreamTestResult> results) {
        Set<Verdict> verdicts =
                results.stream().map(StreamTestResult::verdict).collect(Collectors.toSet());
        if (verdicts.contains(Verdict.FAILED)) {
            return Tone.BAD;
        }
        return verdicts.contains(Verdict.UNKNOWN) ? Tone.OPEN : Tone.GOOD;
    }

    private Story story() {
        Timeline timeline =
                new Timeline(tracks.unit(), tracks.length(), List.of(), tracks(), flaws());
        return new Story(
                        test.title(),
                        switch (result.verdict()) {
                            case PASSED -> Tone.GOOD;
                            case VACUOUS, UNKNOWN -> Tone.OPEN;
                            case FAILED -> Tone.BAD;
                        },
                        StreamTestText.line(result),
                        remarks(),
                        timeline,
                        tracks.drawings(pictures))
                .telling(facts());
    }

    private List<Fact> facts() {
        List<Fact> facts = new ArrayList<>();
        facts.add(
                Fact.of(
                        "asked",
                        "whether some run that %s allows gives the expected output",
                        test.component().qualifiedName()));
        facts.add(RunFacts.time(test.component()));
        RunFacts.completions(test.component(), test.component().automata()).ifPresent(facts::add);
        facts.add(
                Fact.of(
                        "shown",
                        "a run that takes the first choice wherever the model leaves one"));
        if (result.verdict() == Verdict.FAILED) {
            facts.add(
                    Fact.of(
                            "next",
                            "step from the first difference back (Left) to what brought it about;"
                                + " 'arcomat simulate --input %s#%s --choose ask' lets you choose"
                                + " yourself",
                            test.span().file().path(),
                            test.name()));
        }
        return facts;
    }

    private List<Remark> remarks() {
        return result.verdict() == Verdict.FAILED
                ? List.of(Remark.of(Tone.BAD, "The test is here.").about(test.span().firstLine()))
                : List.of();
    }

    private boolean isTimed() {
        return test.component().profile() == Component.Profile.TIME_SYNCHRONOUS;
    }

    private List<Track> tracks() {
        List<Track> all = new ArrayList<>(tracks.inputs());
        for (String port : tracks.outputs()) {
            if (isTimed() && test.expected().containsKey(port)) {
                all.add(expected(port));
            }
            all.add(tracks.output(port));
        }
        all.addAll(tracks.states());
        return all;
    }

    private Track expected(String port) {
        Stream<String> expected =
                test.expected().getOrDefault(port, List.of()).stream().map(TraceTable::text);
        return Track.of(
                TraceTracks.OUTPUTS,
                port + EXPECTED,
                Kind.PORT,
                Stream.concat(expected, Stream.generate(() -> "")).limit(tracks.length()));
    }

    private List<Flaw> flaws() {
        List<Flaw> flaws = new ArrayList<>();
        int last = tracks.length() - 1;
        if (last < 0) {
            return flaws;
        }
        for (Cell cell : result.cells()) {
            if (cell.differs()) {
                int at = Math.min(last, isTimed() ? cell.slice() : event(cell));
                flaws.add(new Flaw(at, cell.port(), text(cell)));
            }
        }
        if (result.verdict() == Verdict.FAILED) {
            result.failure().ifPresent(failure -> flaws.add(new Flaw(last, "", failure)));
        }
        return flaws;
    }

    private static String text(Cell cell) {
        String allowed =
                cell.allowed().isEmpty()
                        ? ""
                        : "; the model allows " + String.join(" or ", cell.allowed());
        return "%s: expected is %s, sent is %s%s"
                .formatted(
                        cell.port(),
                        StreamTestText.messages(cell.expected()),
                        StreamTestText.messages(cell.actual()),
                        allowed);
    }

    /** The event in which a port sends the message of a cell; the last one if it never does. */
    private int event(Cell cell) {
        int sent = 0;
        for (Trace.Step step : run.steps()) {
            sent += step.outputs().messages(cell.port()).size();
            if (sent > cell.slice()) {
                return step.number();
            }
        }
        return tracks.length() - 1;
    }
}
