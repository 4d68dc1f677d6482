package arcomat.report.page;

import arcomat.report.page.Page.Tone;
import arcomat.source.Span;

import com.fasterxml.jackson.annotation.JsonUnwrapped;

import java.util.List;
import java.util.Optional;
import java.util.OptionalInt;

/**
 * A run with what there is to say about it.
 *
 * @param headline what came of it, in a sentence; empty where the page's headline says it
 * @param drawings pictures that follow the run
 */
public record Story(
        String title,
        Tone tone,
        String headline,
        List<Remark> remarks,
        @JsonUnwrapped Timeline timeline,
        List<Drawing> drawings) {
    public Story {
        remarks = List.copyOf(remarks);
        drawings = List.copyOf(drawings);
    }

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

    /**
     * A picture beside a run. What the tracks show at a step is marked in it.
     *
     * @param svg an element {@code svg} without scripts and styles
     * @param tracks names of the tracks that it follows
     */
    public record Drawing(String title, String svg, List<String> tracks) {
        public Drawing {
            tracks = List.copyOf(tracks);
        }
    }
}
