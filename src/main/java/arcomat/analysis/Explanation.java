package arcomat.analysis;

import arcomat.analysis.Verdict.Sentence;
import arcomat.analysis.engine.Comparison.Allowed;
import arcomat.analysis.engine.Comparison.Forbidden;
import arcomat.model.Automaton;
import arcomat.model.Trace;
import arcomat.semantics.Sent;
import arcomat.source.Span;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.stream.Collectors;

/** Says why a refinement fails: what the left side did last, and what the right one would allow. */
final class Explanation {
    private Explanation() {}

    static List<Sentence> of(Promise left, Promise right, Forbidden forbidden, int number) {
        List<Sentence> sentences = new ArrayList<>();
        boolean beginning = forbidden.left().isEmpty();
        String when = beginning ? "At the start" : "With input %d".formatted(number);
        sentences.add(
                new Sentence(
                        "%s, %s %s%s"
                                .formatted(
                                        when,
                                        left.title(),
                                        forbidden.error()
                                                ? "ends in an error"
                                                : "sends " + words(forbidden.sent()),
                                        by(left, forbidden.left(), forbidden.causes())),
                        place(left, forbidden.causes())));
        for (Allowed allowed : forbidden.right()) {
            sentences.add(
                    new Sentence(
                            "%s allows %s%s"
                                    .formatted(
                                            right.title(),
                                            allowed.error() ? "an error" : words(allowed.sent()),
                                            by(right, allowed.configuration(), allowed.causes())),
                            place(right, allowed.causes())));
        }
        if (forbidden.right().isEmpty()) {
            sentences.add(
                    new Sentence(
                            right.title() + " allows nothing any more",
                            Optional.of(right.component().span())));
        }
        return sentences;
    }

    static String words(Map<String, Sent> sent) {
        String words =
                sent.entrySet().stream()
                        .filter(each -> !each.getValue().equals(Sent.SILENCE))
                        .map(each -> each.getKey() + " = " + each.getValue())
                        .collect(Collectors.joining(", "));
        return words.isEmpty() ? "nothing" : words;
    }

    static String by(Promise promise, String before, List<Trace.Cause> causes) {
        if (before.isEmpty()) {
            return "";
        }
        List<String> words = new ArrayList<>();
        for (int i = 0; i < causes.size(); i++) {
            words.add(cause(promise, i, causes.get(i)));
        }
        return words.isEmpty() ? "" : ", in " + before + ": " + String.join("; ", words);
    }

    private static String cause(Promise promise, int index, Trace.Cause cause) {
        if (cause instanceof Trace.Taken taken) {
            Optional<Automaton> automaton = automaton(promise, index, taken);
            String states =
                    automaton
                            .map(
                                    a ->
                                            a.states().get(taken.transition().source())
                                                    + " -> "
                                                    + a.states().get(taken.transition().target()))
                            .orElse("of a part");
            return "transition " + states;
        }
        Automaton.Completion completion = ((Trace.Completed) cause).completion();
        return "no transition fits, completion "
                + completion.name().toLowerCase(java.util.Locale.ROOT);
    }

    /** That of the promise, if the transition is one of its own. */
    private static Optional<Automaton> automaton(Promise promise, int index, Trace.Taken taken) {
        return promise.automata().stream()
                .filter(a -> taken.index() < a.transitions().size())
                .filter(a -> a.transitions().get(taken.index()).equals(taken.transition()))
                .findFirst();
    }

    static Optional<Span> place(Promise promise, List<Trace.Cause> causes) {
        for (Trace.Cause cause : causes) {
            if (cause instanceof Trace.Taken taken && taken.transition().span() != null) {
                return Optional.of(taken.transition().span());
            }
        }
        return promise.automata().isEmpty()
                ? Optional.ofNullable(promise.component().span())
                : Optional.ofNullable(promise.automata().get(0).span());
    }
}
