package arcomat.analysis.refinement;

import arcomat.analysis.refinement.Verdict.Sentence;
import arcomat.analysis.search.product.Counterexample.Allowed;
import arcomat.analysis.search.product.Counterexample.Forbidden;
import arcomat.model.Trace;
import arcomat.semantics.Promise;
import arcomat.semantics.expression.Sent;
import arcomat.source.Span;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.stream.Collectors;

/** Says why a refinement fails: what the left side did last, and what the right one would allow. */
public final class Explanation {
    private Explanation() {}

    static List<Sentence> of(Promise left, Promise right, Forbidden forbidden, int number) {
        List<Sentence> sentences = new ArrayList<>();
        boolean beginning = forbidden.left().isEmpty();
        String when = beginning ? "At the start" : "With input %d".formatted(number);
        String did =
                forbidden
                        .error()
                        .map(error -> "ends in an " + error + still(forbidden.sent()))
                        .orElse("sends " + words(forbidden.sent()));
        String by = by(left, forbidden.left(), forbidden.causes());
        sentences.add(
                new Sentence(
                        when + ", " + left.title() + " " + did + by,
                        place(left, forbidden.causes())));
        for (Allowed allowed : forbidden.right()) {
            sentences.add(allows(right, allowed, allowed(allowed, forbidden)));
        }
        if (forbidden.right().isEmpty()) {
            sentences.add(
                    Sentence.at(
                            right.component().span(), "%s allows nothing any more", right.title()));
        }
        return sentences;
    }

    /** That a promise allows something in a step of its own, in words. */
    public static Sentence allows(Promise promise, Allowed step, String words) {
        String by = by(promise, step.configuration(), step.causes());
        String text = "%s allows %s%s".formatted(promise.title(), words, by);
        return new Sentence(text, place(promise, step.causes()));
    }

    /** What earlier reactions show in the slice in which a run ends. */
    private static String still(Map<String, Sent> sent) {
        return sent.isEmpty() ? "" : " in a slice that still shows " + words(sent);
    }

    private static String allowed(Allowed allowed, Forbidden forbidden) {
        boolean errorForbidden = forbidden.error().isPresent();
        boolean onlyErrors = forbidden.right().stream().allMatch(Allowed::error);
        if (allowed.error()) {
            boolean showsLess =
                    errorForbidden && allowed.sent().isEmpty() && !forbidden.sent().isEmpty();
            return (onlyErrors ? "only an error" : "an error")
                    + (showsLess ? " in a slice that shows nothing" : still(allowed.sent()));
        }
        return words(allowed, errorForbidden);
    }

    /** Ports that are left open are only mentioned where all are. */
    private static String words(Map<String, Sent> sent) {
        if (!sent.isEmpty() && sent.values().stream().allMatch(Sent.Anything.class::isInstance)) {
            return "anything";
        }
        String words =
                sent.entrySet().stream()
                        .filter(each -> !each.getValue().equals(Sent.SILENCE))
                        .filter(each -> !(each.getValue() instanceof Sent.Anything))
                        .map(each -> each.getKey() + " = " + each.getValue())
                        .collect(Collectors.joining(", "));
        return words.isEmpty() ? "nothing" : words;
    }

    /**
     * What is allowed besides errors.
     *
     * @param noError whether it is told apart from an error that is not
     */
    public static String words(Allowed allowed, boolean noError) {
        String words = words(allowed.sent());
        return switch (words) {
            case "nothing" -> silence(allowed.sent());
            case "anything" -> noError ? "any output, but no error" : words;
            default -> words;
        };
    }

    /** What is allowed where no message has to be sent, and not everything is left open. */
    private static String silence(Map<String, Sent> sent) {
        List<String> silent =
                sent.entrySet().stream()
                        .filter(each -> each.getValue().equals(Sent.SILENCE))
                        .map(Map.Entry::getKey)
                        .toList();
        return silent.size() == sent.size()
                ? "only silence"
                : "only silence on " + String.join(", ", silent);
    }

    private static String by(Promise promise, String before, List<Trace.Cause> causes) {
        if (before.isEmpty()) {
            return "";
        }
        List<String> words = new Causes(promise).words(causes);
        return words.isEmpty() ? "" : ", in " + before + ": " + String.join("; ", words);
    }

    private static Optional<Span> place(Promise promise, List<Trace.Cause> causes) {
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
