package arcomat.report.page;

import arcomat.source.Span;

import java.util.Optional;
import java.util.OptionalInt;

/**
 * A sentence about a run.
 *
 * @param place in a model, shown with its lines
 * @param at the step that it is about
 */
public record Remark(Tone tone, String text, Optional<Span> place, OptionalInt at) {

    public static Remark of(Tone tone, String text) {
        return new Remark(tone, text, Optional.empty(), OptionalInt.empty());
    }

    public Remark about(Span span) {
        return new Remark(tone, text, Optional.of(span), at);
    }

    public Remark at(int step) {
        return new Remark(tone, text, place, OptionalInt.of(step));
    }
}
