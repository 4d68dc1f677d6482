package arcomat.pipeline.analysis.guest;

import arcomat.analysis.automaton.OutsideQuestion.Answer;
import arcomat.analysis.automaton.exploration.Exploration;
import arcomat.analysis.automaton.exploration.Visit;
import arcomat.guest.AutomatonAnalysis;
import arcomat.guest.AutomatonRuns;
import arcomat.guest.host.Guests.Question;
import arcomat.source.Diagnostic;
import arcomat.source.Span;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Objects;
import java.util.Optional;

/** Takes what a guest's analysis finds, and puts the guest's name to it. */
final class QuestionFindings implements AutomatonAnalysis.Findings {
    private final Question question;
    private final Exploration explored;
    private final List<Answer> all = new ArrayList<>();

    QuestionFindings(Question question, Exploration explored) {
        this.question = question;
        this.explored = explored;
    }

    @Override
    public void report(String code, Span place, String message, Object... values) {
        add(Optional.empty(), code, place, message, values);
    }

    @Override
    public void reportAt(
            AutomatonRuns.Reached seen, String code, Span place, String message, Object... values) {
        add(Optional.of(explored.visit(seen.number())), code, place, message, values);
    }

    private void add(
            Optional<Visit> where, String code, Span place, String message, Object... values) {
        if (!question.codes().contains(code)) {
            throw new IllegalArgumentException("it has not said that it has a code '" + code + "'");
        }
        Objects.requireNonNull(place, "a finding without a place");
        String words = values.length == 0 ? message : String.format(Locale.ROOT, message, values);
        String named = words + " (guest '" + question.guest() + "')";
        all.add(new Answer(Diagnostic.warning(code, place, named), where));
    }

    List<Answer> all() {
        return List.copyOf(all);
    }
}
