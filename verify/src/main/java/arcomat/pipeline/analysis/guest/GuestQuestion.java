package arcomat.pipeline.analysis.guest;

import arcomat.analysis.automaton.OutsideQuestion;
import arcomat.analysis.automaton.exploration.Exploration;
import arcomat.analysis.automaton.exploration.Situation;
import arcomat.analysis.reachability.Subject;
import arcomat.check.guest.GuestFailure;
import arcomat.check.guest.GuestThread;
import arcomat.guest.AutomatonRuns;
import arcomat.guest.host.Guests;
import arcomat.guest.host.Guests.Question;
import arcomat.source.Diagnostic;
import arcomat.source.Span;

import java.time.Duration;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.TimeoutException;

/**
 * A guest's question about automata, asked in a thread of its own: what goes wrong there is a
 * finding, and nobody may take that automaton for one that was looked at.
 */
public final class GuestQuestion implements OutsideQuestion {
    /** An analysis goes over what is known already; as long as that, laws may take as well. */
    private static final Duration LIMIT = Duration.ofSeconds(60);

    private final Question question;
    private final Duration limit;
    private boolean tookTooLong;

    /**
     * @param limit after which the guest is left alone, for the rest of the run
     */
    GuestQuestion(Question question, Duration limit) {
        this.question = question;
        this.limit = limit;
    }

    /** Those of all guests, for one run. */
    public static List<OutsideQuestion> all(Guests guests) {
        return guests.questions().stream()
                .<OutsideQuestion>map(each -> new GuestQuestion(each, LIMIT))
                .toList();
    }

    @Override
    public List<Answer> ask(Subject subject, Exploration explored, List<Situation> seen) {
        GuestFailure failure = new GuestFailure(question.guest());
        Span place = subject.automaton().span();
        if (tookTooLong) {
            return alone(failure.tooLong("analyses", place, limit));
        }
        AutomatonRuns runs = RunsForGuests.of(subject, explored, seen);
        QuestionFindings findings = new QuestionFindings(question, explored);
        try {
            return new GuestThread(question.guest(), limit)
                    .call(
                            () -> {
                                question.analysis().examine(runs, findings);
                                return findings.all();
                            });
        } catch (ExecutionException e) {
            Throwable cause = e.getCause() == null ? e : e.getCause();
            String codes = String.join(", ", question.codes());
            return alone(failure.analysisFailed(codes, place, cause));
        } catch (TimeoutException e) {
            tookTooLong = true;
            return alone(failure.tooLong("analyses", place, limit));
        }
    }

    private static List<Answer> alone(Diagnostic finding) {
        return List.of(new Answer(finding, Optional.empty()));
    }
}
