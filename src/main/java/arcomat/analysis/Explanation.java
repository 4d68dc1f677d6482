package arcomat.analysis;

import arcomat.analysis.Verdict.Sentence;
import arcomat.analysis.engine.Comparison.Allowed;
import arcomat.analysis.engine.Comparison.Forbidden;
import arcomat.model.Automaton;
import arcomat.model.Component;
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
                                        forbidden
                                                .error()
                                                .map(
                                                        error ->
                                                                "ends in an "
                                                                        + error
                                                                        + still(forbidden.sent()))
                                                .orElse("sends " + words(forbidden.sent())),
                                        by(left, forbidden.left(), forbidden.causes())),
                        place(left, forbidden.causes())));
        for (Allowed allowed : forbidden.right()) {
            sentences.add(
                    new Sentence(
                            "%s allows %s%s"
                                    .formatted(
                                            right.title(),
                                            allowed(allowed, forbidden),
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

    /** What earlier reactions show in the slice in which a run ends. */
    private static String still(Map<String, Sent> sent) {
        return sent.isEmpty() ? "" : " in a slice that still shows " + words(sent);
    }

    private static String allowed(Allowed allowed, Forbidden forbidden) {
        boolean errorForbidden = forbidden.error().isPresent();
        if (allowed.error()) {
            boolean showsLess =
                    errorForbidden && allowed.sent().isEmpty() && !forbidden.sent().isEmpty();
            return "an error"
                    + (showsLess ? " in a slice that shows nothing" : still(allowed.sent()));
        }
        String words = words(allowed.sent());
        return switch (words) {
            case "nothing" -> "only silence";
            case "anything" -> errorForbidden ? "any output, but no error" : words;
            default -> words;
        };
    }

    /** Ports that are left open are only mentioned where all are. */
    static String words(Map<String, Sent> sent) {
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

    static String by(Promise promise, String before, List<Trace.Cause> causes) {
        if (before.isEmpty()) {
            return "";
        }
        List<String> words = new ArrayList<>();
        causes.forEach(each -> words.add(cause(promise, each)));
        return words.isEmpty() ? "" : ", in " + before + ": " + String.join("; ", words);
    }

    private static String cause(Promise promise, Trace.Cause cause) {
        if (cause instanceof Trace.Taken taken) {
            return promise.isComposition()
                    ? ofPart(promise.component(), taken).orElse("transition of a part")
                    : among(promise.automata(), taken).orElse("transition");
        }
        Automaton.Completion completion = ((Trace.Completed) cause).completion();
        return "no transition fits, completion "
                + completion.name().toLowerCase(java.util.Locale.ROOT);
    }

    private static Optional<String> among(List<Automaton> automata, Trace.Taken taken) {
        return automata.stream()
                .filter(a -> taken.index() < a.transitions().size())
                .filter(a -> a.transitions().get(taken.index()).equals(taken.transition()))
                .findFirst()
                .map(a -> "transition " + states(a, taken.transition()));
    }

    private static String states(Automaton automaton, Automaton.Transition transition) {
        return automaton.states().get(transition.source())
                + " -> "
                + automaton.states().get(transition.target());
    }

    private static Optional<String> ofPart(Component component, Trace.Taken taken) {
        if (component.body() instanceof Component.Atomic atomic) {
            return among(atomic.automata(), taken).map(t -> t + " of " + component.name());
        }
        return ((Component.Composite) component.body())
                .parts().stream()
                        .flatMap(part -> ofPart(part.component(), taken).stream())
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
