package arcomat.report.verdict;

import arcomat.analysis.contradiction.Consistency;
import arcomat.analysis.contradiction.Consistency.Contradiction;
import arcomat.analysis.game.CounterStrategy.Turn;
import arcomat.analysis.refinement.TraceReplay;
import arcomat.analysis.refinement.Verdict.Sentence;
import arcomat.analysis.search.Moment;
import arcomat.model.Automaton;
import arcomat.model.Letter;
import arcomat.report.page.Page;
import arcomat.report.page.Page.Tone;
import arcomat.report.page.Story;
import arcomat.report.page.Story.Drawing;
import arcomat.report.page.Story.Fact;
import arcomat.report.page.Story.Remark;
import arcomat.report.page.Timeline;
import arcomat.report.page.Timeline.Flaw;
import arcomat.report.page.Track;
import arcomat.report.page.Track.Kind;
import arcomat.report.run.RunDrawings;
import arcomat.report.run.RunFacts;
import arcomat.report.run.TraceTracks;
import arcomat.semantics.Promise;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.stream.Collectors;
import java.util.stream.IntStream;

/** Contradictions as a page: inputs, what may be answered, and the requirements beside them. */
public final class ConsistencyPage {
    private static final String ANSWERS = "may be answered";
    private static final String GOES = " goes";

    private final Promise asked;
    private final Contradiction contradiction;
    private final RunDrawings pictures;
    private final List<Contradiction.Step> steps;

    private ConsistencyPage(Promise asked, Contradiction contradiction, RunDrawings pictures) {
        this.asked = asked;
        this.pictures = pictures;
        this.contradiction = contradiction;
        steps = contradiction.steps();
    }

    /**
     * @param asked the requirements
     * @param controller the text of one that keeps them all, where there is one
     */
    public static Page of(Promise asked, Consistency found, Optional<String> controller) {
        RunDrawings pictures = new RunDrawings();
        List<Story> stories = new ArrayList<>();
        found.contradictions()
                .forEach(each -> stories.add(new ConsistencyPage(asked, each, pictures).story()));
        if (stories.isEmpty()) {
            stories.add(harmony(asked, found, controller, pictures));
        }
        stories.replaceAll(each -> each.telling(facts(asked, found)));
        return new Page(
                "contradictions",
                asked.title(),
                VerdictPage.tone(found.answer()),
                ConsistencyText.headline(asked.title(), found),
                stories);
    }

    private static List<Fact> facts(Promise asked, Consistency found) {
        List<Fact> facts = new ArrayList<>();
        facts.add(
                Fact.of(
                        "asked",
                        "whether all requirements on %s can be kept together, whatever comes in",
                        asked.title()));
        facts.add(RunFacts.time(asked.component()));
        RunFacts.completions(asked.component(), asked.automata()).ifPresent(facts::add);
        if (!found.contradictions().isEmpty()) {
            facts.add(
                    new Fact(
                            "next",
                            "each run below shows requirements that cannot be kept together: give"
                                    + " one of them up, or let it allow more"));
        }
        return facts;
    }

    /** The requirements themselves, and what keeps them. */
    private static Story harmony(
            Promise asked, Consistency found, Optional<String> controller, RunDrawings pictures) {
        List<Remark> remarks = new ArrayList<>();
        found.notes().forEach(note -> remarks.add(Remark.of(Tone.NEUTRAL, note)));
        if (controller.isPresent()) {
            remarks.add(Remark.of(Tone.GOOD, "A controller keeps them all; --out writes it."));
        }
        List<Drawing> drawings = new ArrayList<>();
        for (Automaton each : asked.automata()) {
            String name = ConsistencyText.name(each);
            drawings.add(pictures.of(name, asked.component(), each, List.of()));
        }
        Tone tone = VerdictPage.tone(found.answer());
        return new Story("", tone, "", remarks, Timeline.none("step"), drawings);
    }

    private Story story() {
        List<Letter> inputs = steps.stream().map(Contradiction.Step::input).toList();
        List<Track> tracks = new ArrayList<>(TraceTracks.inputs(inputs));
        tracks.add(answers());
        List<Drawing> drawings = new ArrayList<>();
        for (Automaton automaton : contradiction.requirements()) {
            String name = ConsistencyText.name(automaton);
            tracks.add(way(automaton, name + GOES));
            drawings.add(pictures.of(name, asked.component(), automaton, List.of(name + GOES)));
        }
        Timeline timeline = new Timeline("step", steps.size(), List.of(), tracks, flaws());
        String names = String.join(", ", ConsistencyText.names(contradiction));
        return new Story(
                names,
                Tone.BAD,
                ConsistencyText.summary(contradiction).replaceFirst(":$", ""),
                remarks(),
                timeline,
                drawings);
    }

    private Track answers() {
        return Track.of(
                TraceTracks.OUTPUTS, ANSWERS, Kind.STATE, steps.stream().map(this::answers));
    }

    private String answers(Contradiction.Step step) {
        return step.answers().isEmpty()
                ? "none complies"
                : step.answers().stream().map(this::text).collect(Collectors.joining("  or  "));
    }

    private String text(Turn.Answer answer) {
        List<String> sent = VerdictText.outputs(answer.outputs());
        String text = sent.isEmpty() ? "nothing" : String.join(", ", sent);
        return isStraight() ? text : text + " (then step " + answer.next() + ")";
    }

    /** Whether each step is followed by the next one, whatever is answered. */
    private boolean isStraight() {
        return IntStream.range(0, steps.size())
                .allMatch(i -> steps.get(i).answers().stream().allMatch(a -> a.next() == i + 1));
    }

    private Track way(Automaton automaton, String name) {
        List<Moment> moments =
                steps.stream()
                        .map(step -> new Moment(step.input(), sent(step), "", List.of()))
                        .toList();
        return isStraight()
                ? RunDrawings.way(name, TraceReplay.anywhere(asked, automaton, moments))
                : RunDrawings.way(name, List.of());
    }

    /** What is surely sent; where there are several answers, that is left open. */
    private static Map<String, arcomat.semantics.expression.Sent> sent(Contradiction.Step step) {
        return step.answers().size() == 1 ? step.answers().get(0).outputs() : Map.of();
    }

    private List<Flaw> flaws() {
        return IntStream.range(0, steps.size())
                .filter(i -> steps.get(i).answers().isEmpty())
                .mapToObj(i -> new Flaw(i, ANSWERS, "whatever is answered breaks a requirement"))
                .toList();
    }

    private List<Remark> remarks() {
        List<Remark> remarks = new ArrayList<>();
        for (int i = 0; i < steps.size(); i++) {
            for (Sentence demand : steps.get(i).demands()) {
                remarks.add(VerdictPage.remark(Tone.BAD, demand).at(i));
            }
        }
        return remarks;
    }
}
