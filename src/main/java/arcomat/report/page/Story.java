package arcomat.report.page;

import arcomat.report.page.Page.Tone;
import arcomat.source.Span;

import com.fasterxml.jackson.annotation.JsonUnwrapped;

import java.util.Collections;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalInt;

/**
 * A run with what there is to say about it.
 *
 * @param headline what came of it, in a sentence; empty where the page's headline says it
 * @param drawings pictures that follow the run
 * @param facts what was asked, what that means, what to try next
 */
public record Story(
        String title,
        Tone tone,
        String headline,
        List<Remark> remarks,
        @JsonUnwrapped Timeline timeline,
        List<Drawing> drawings,
        List<Fact> facts) {
    public Story {
        remarks = List.copyOf(remarks);
        drawings = List.copyOf(drawings);
        facts = List.copyOf(facts);
    }

    /** One of which nothing is told but what came of it. */
    public Story(
            String title,
            Tone tone,
            String headline,
            List<Remark> remarks,
            Timeline timeline,
            List<Drawing> drawings) {
        this(title, tone, headline, remarks, timeline, drawings, List.of());
    }

    /** The same with what was asked, and what to do with the answer. */
    public Story telling(List<Fact> told) {
        return new Story(title, tone, headline, remarks, timeline, drawings, told);
    }

    /**
     * What a reader may want to know who did not ask himself.
     *
     * @param label such as {@code asked} or {@code next}
     */
    public record Fact(String label, String text) {
        /** With {@link String#format} of the text. */
        public static Fact of(String label, String text, Object... arguments) {
            return new Fact(label, text.formatted(arguments));
        }
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
     * @param carried names of the tracks that say what its ports carry, by the paths of the ports
     */
    public record Drawing(
            String title, String svg, List<String> tracks, Map<String, String> carried) {
        public Drawing {
            tracks = List.copyOf(tracks);
            carried = Collections.unmodifiableMap(new LinkedHashMap<>(carried));
        }

        /** The same below another heading. */
        public Drawing titled(String other) {
            return new Drawing(other, svg, tracks, carried);
        }

        /** One without ports. */
        public Drawing(String title, String svg, List<String> tracks) {
            this(title, svg, tracks, Map.of());
        }
    }
}
