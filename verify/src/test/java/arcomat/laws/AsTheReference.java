package arcomat.laws;

import arcomat.analysis.refinement.Verdict;
import arcomat.analysis.search.Moment;
import arcomat.laws.draw.Draw;
import arcomat.laws.naive.NaiveQuestion;
import arcomat.model.Component;
import arcomat.model.Letter;
import arcomat.model.Value;
import arcomat.semantics.Promise;
import arcomat.semantics.expression.Sent;
import arcomat.source.SourceFile;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;

/**
 * A verdict is the one of the reference, and its counterexample as short. But the reference leaves
 * open one message for an event where the engine knows of several, and it notices at once where
 * several automata together allow nothing any more, which the engine asks one by one.
 */
final class AsTheReference implements Law {
    private static final int MOST_INPUTS = 5;

    @Override
    public String name() {
        return "0 as the reference";
    }

    @Override
    public List<SourceFile> draw(Draw draw) {
        return Pairs.draw(draw);
    }

    @Override
    public Outcome check(Models models) {
        return check(
                Questions.promise(models.component(Pairs.LEFT)),
                Questions.promise(models.component(Pairs.RIGHT)),
                Questions.command(Pairs.LEFT, Pairs.RIGHT));
    }

    static Outcome check(Promise left, Promise right, String command) {
        Verdict verdict = Questions.refines(left, right);
        if (verdict.answer() == Verdict.Answer.UNKNOWN) {
            return Outcome.SKIPPED;
        }
        NaiveQuestion.Answer answer =
                NaiveQuestion.ask(
                        left.component(),
                        left.automata(),
                        right.component(),
                        right.automata(),
                        letters(verdict.trace()),
                        Math.max(MOST_INPUTS, verdict.trace().size()));
        if (answer.isUnknown()) {
            return Outcome.SKIPPED;
        }
        if (!answer.fails() && sendsSeveral(verdict.trace())) {
            return Outcome.SKIPPED;
        }
        String said = answer.text();
        boolean lengthMayDiffer =
                left.component().profile() == Component.Profile.EVENT_DRIVEN
                        || right.each().size() > 1;
        boolean bothFail = Questions.fails(verdict) && answer.fails();
        return agrees(verdict, answer) || lengthMayDiffer && bothFail
                ? Outcome.KEPT
                : Outcome.broken(
                        Questions.text(verdict) + ", but the reference says: " + said, command);
    }

    /** Whether a port carries several messages for an event: that the reference does not try. */
    private static boolean sendsSeveral(List<Moment> trace) {
        return trace.stream()
                .flatMap(moment -> moment.outputs().values().stream())
                .anyMatch(
                        sent ->
                                sent instanceof Sent.Messages messages
                                        && messages.values().size() > 1);
    }

    private static List<Letter> letters(List<Moment> trace) {
        List<Letter> letters = new ArrayList<>();
        for (Moment moment : trace) {
            letters.add(moment.input());
            Map<String, List<Value>> outputs = new LinkedHashMap<>();
            moment.outputs()
                    .forEach(
                            (port, sent) -> {
                                if (sent instanceof Sent.Messages messages) {
                                    outputs.put(port, messages.values());
                                }
                            });
            letters.add(new Letter(outputs));
        }
        return letters;
    }

    private static boolean agrees(Verdict verdict, NaiveQuestion.Answer answer) {
        return switch (verdict.reason()) {
            case "delay" -> !answer.fitsFeedback();
            case "behaviour" ->
                    isShortest(verdict.trace().size() - 1, answer)
                            || verdict.mayBeShorter() && answer.fails();
            case "" -> !answer.fails();
            default -> true;
        };
    }

    /** Where not all is tried, the reference may miss a failure; one that it finds is there. */
    private static boolean isShortest(int inputs, NaiveQuestion.Answer answer) {
        int found = answer.shortest().orElse(Integer.MAX_VALUE);
        return found == inputs || !answer.isComplete() && found > inputs;
    }
}
