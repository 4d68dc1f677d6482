package arcomat.report.verdict;

import arcomat.analysis.refinement.Answered;
import arcomat.analysis.refinement.Verdict;
import arcomat.analysis.refinement.Verdict.Answer;
import arcomat.analysis.refinement.Verdict.Sentence;
import arcomat.analysis.search.Moment;
import arcomat.report.page.Page;
import arcomat.report.page.Page.Tone;
import arcomat.report.page.Story;
import arcomat.report.page.Story.Remark;
import arcomat.report.page.Timeline;
import arcomat.report.page.Timeline.Flaw;
import arcomat.report.run.RunDrawings;
import arcomat.report.text.Style;

import java.util.ArrayList;
import java.util.List;
import java.util.OptionalInt;

/** Verdicts as a page: each counterexample as a run, beside the models of both sides. */
public final class VerdictPage {
    private static final String SENT =
            "each message stands in the step in which it is sent. What a filled port sends is read"
                    + " one step later.";

    private VerdictPage() {}

    /** Of one question, with limits that nobody tells. */
    public static Page of(String command, Answered answered) {
        return of(command, answered, "");
    }

    /**
     * Of one question.
     *
     * @param limits how long was searched at most, in words
     */
    public static Page of(String command, Answered answered, String limits) {
        Verdict verdict = answered.verdict();
        return new Page(
                command,
                answered.left() + " and " + answered.right(),
                tone(verdict.answer()),
                sentence(answered),
                List.of(
                        story("", "", answered, new RunDrawings())
                                .telling(VerdictFacts.of(answered, limits))));
    }

    /**
     * Of many questions.
     *
     * @param limits how long was searched at most, in words
     */
    public static Page of(String command, String title, List<Answered> answers, String limits) {
        List<Story> stories = new ArrayList<>();
        RunDrawings pictures = new RunDrawings();
        Answer worst = Answer.HOLDS;
        for (Answered each : answers) {
            Story story = story(Terms.name(each), sentence(each), each, pictures);
            stories.add(story.telling(VerdictFacts.of(each, limits)));
            worst = worst.and(each.verdict().answer());
        }
        List<Verdict> verdicts = answers.stream().map(Answered::verdict).toList();
        String headline = ObligationsText.summary(verdicts, Style.PLAIN);
        return new Page(command, title, tone(worst), headline, stories);
    }

    private static String sentence(Answered each) {
        String answer = VerdictText.answer(each.verdict().answer(), Style.PLAIN);
        return answer + ": " + Terms.headline(each);
    }

    static Tone tone(Answer answer) {
        return switch (answer) {
            case HOLDS -> Tone.GOOD;
            case FAILS -> Tone.BAD;
            case UNKNOWN -> Tone.OPEN;
        };
    }

    private static Story story(
            String title, String headline, Answered answered, RunDrawings pictures) {
        Verdict verdict = answered.verdict();
        MomentTracks tracks = new MomentTracks(answered, pictures);
        List<Moment> trace = verdict.trace();
        List<Flaw> flaws = new ArrayList<>();
        if (verdict.answer() == Answer.FAILS && !trace.isEmpty()) {
            String text =
                    verdict.explanation().isEmpty()
                            ? "not possible on the right"
                            : verdict.explanation().get(0).text();
            flaws.add(new Flaw(trace.size() - 1, Terms.of(answered).right(), text));
        }
        Timeline timeline =
                new Timeline(
                        Terms.of(answered).step(), trace.size(), List.of(), tracks.tracks(), flaws);
        return new Story(
                title,
                tone(verdict.answer()),
                headline,
                remarks(answered, tracks),
                timeline,
                tracks.drawings());
    }

    private static List<Remark> remarks(Answered answered, MomentTracks tracks) {
        Verdict verdict = answered.verdict();
        List<Remark> remarks = new ArrayList<>();
        verdict.explanation().forEach(each -> remarks.add(remark(Tone.BAD, each)));
        verdict.notes().forEach(note -> remarks.add(Remark.of(Tone.NEUTRAL, note)));
        if (answered.question() == Answered.Question.REFINEMENT) {
            if (tracks.tellsOfParts()) {
                remarks.add(
                        Remark.of(
                                Tone.NEUTRAL,
                                "Rows of parts tell one run of the left side that shows this: "
                                        + SENT));
            }
            if (tracks.tellsOfPartsOnTheRight()) {
                remarks.add(
                        Remark.of(
                                Tone.NEUTRAL,
                                "Rows of parts on the right tell one run of the right side that"
                                        + " shows the same, as long as it can: "
                                        + SENT));
            }
        }
        if (!verdict.explored().isNothing()) {
            remarks.add(Remark.of(Tone.NEUTRAL, VerdictText.explored(verdict)));
        }
        return remarks;
    }

    static Remark remark(Tone tone, Sentence sentence) {
        return new Remark(tone, sentence.text(), sentence.place(), OptionalInt.empty());
    }
}
