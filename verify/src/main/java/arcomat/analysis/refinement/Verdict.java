package arcomat.analysis.refinement;

import arcomat.analysis.search.Moment;
import arcomat.analysis.search.product.Certificate;
import arcomat.analysis.search.product.Certificate.Form;
import arcomat.analysis.search.product.TraceInclusion;
import arcomat.source.Span;

import java.util.ArrayList;
import java.util.Collection;
import java.util.List;
import java.util.Optional;
import java.util.function.BinaryOperator;
import java.util.stream.Collectors;
import java.util.stream.Stream;

/**
 * The answer to a question about models.
 *
 * @param reason of a failure {@code behaviour}, {@code interface}, {@code delay} or {@code
 *     invariant}; of an unknown what stood in the way; else empty
 * @param simulation whether a simulation was found; empty where that was not asked or not decided
 * @param trace a shortest run that the right side forbids, the initial outputs first; of an
 *     invariant, slice by slice what can be seen, the last one breaks it; only of a failure; where
 *     there {@link #mayBeShorter may be a shorter one}, a note says so
 * @param explanation why it fails, in sentences, each with the place that it is about
 * @param notes what else a reader should know: that it holds because nothing is promised, or fails
 *     only because outputs come late, say
 */
public record Verdict(
        Answer answer,
        String reason,
        Optional<Boolean> simulation,
        List<Moment> trace,
        List<Sentence> explanation,
        List<String> notes,
        Explored explored) {
    public Verdict {
        trace = List.copyOf(trace);
        explanation = List.copyOf(explanation);
        notes = List.copyOf(notes);
    }

    private static final int MOST_NAMED = 5;

    private static final String PROVED =
            "proved symbolically: an inductive invariant of %s, verified;"
                    + " not all pairs were explored";

    private static final String SHORTER =
            "not all inputs could be told apart: there may be a shorter run";

    /** Whether a question is answered with yes, no, or not at all. */
    public enum Answer {
        HOLDS,
        FAILS,
        UNKNOWN;

        /** For both questions at once: fails if one does, else unknown if one is. */
        public Answer and(Answer other) {
            return this == FAILS || other == HOLDS
                    ? this
                    : other == FAILS || this == HOLDS ? other : this;
        }
    }

    /**
     * How far a search went: pairs that were compared and configurations of both sides.
     *
     * @param left empty where counting would have taken longer than the search may
     */
    public record Explored(long pairs, Optional<Integer> left, int right) {
        public static final Explored NOTHING = new Explored(0, 0, 0);

        public Explored(long pairs, int left, int right) {
            this(pairs, Optional.of(left), right);
        }

        /**
         * All of them as one.
         *
         * @param ofLeft what two numbers of configurations are together
         */
        static Explored together(Collection<Explored> all, BinaryOperator<Integer> ofLeft) {
            return new Explored(
                    all.stream().mapToLong(Explored::pairs).sum(),
                    all.stream()
                            .map(Explored::left)
                            .reduce(Optional.of(0), (one, other) -> known(one, other, ofLeft)),
                    all.stream().mapToInt(Explored::right).sum());
        }

        private static Optional<Integer> known(
                Optional<Integer> one, Optional<Integer> other, BinaryOperator<Integer> together) {
            return one.flatMap(mine -> other.map(its -> together.apply(mine, its)));
        }

        /** Whether the answer was found without any search. */
        public boolean isNothing() {
            return equals(NOTHING);
        }
    }

    /** A sentence about a place in a model. */
    public record Sentence(String text, Optional<Span> place) {

        /**
         * @param place null where there is none
         * @param format of the text, with the words that fill it in
         */
        public static Sentence at(Span place, String format, Object... words) {
            return new Sentence(format.formatted(words), Optional.ofNullable(place));
        }
    }

    public static Verdict holds(
            Optional<Boolean> simulation, List<String> notes, Explored explored) {
        return new Verdict(Answer.HOLDS, "", simulation, List.of(), List.of(), notes, explored);
    }

    /** Holds by certificates that have been verified. */
    public static Verdict proved(List<Certificate> certificates) {
        String sizes =
                Stream.of(size(certificates, false, "pair"), size(certificates, true, "clause"))
                        .flatMap(Optional::stream)
                        .collect(Collectors.joining(" and "));
        return holds(
                Optional.empty(),
                List.of("verified: a certificate with " + sizes),
                Explored.NOTHING);
    }

    /** Of those that are of clauses, or of the others; empty where there are none. */
    private static Optional<String> size(
            List<Certificate> certificates, boolean ofClauses, String entry) {
        return certificates.stream()
                .filter(each -> (each.form() == Form.CLAUSES) == ofClauses)
                .map(each -> each.entries().size())
                .reduce(Integer::sum)
                .map(n -> n == 1 ? "1 " + entry : (n == 0 ? "no" : n) + " " + entry + "s");
    }

    /** By its behaviour, as a trace shows. */
    public static Verdict fails(List<Moment> trace, List<Sentence> explanation, Explored explored) {
        return fails("behaviour", Optional.of(false), trace, explanation, explored);
    }

    /** An invariant, by a slice in which it is not true. */
    static Verdict breaks(List<Moment> slices, List<Sentence> explanation, Explored explored) {
        return fails("invariant", Optional.empty(), slices, explanation, explored);
    }

    public static Verdict fails(String reason, List<Sentence> explanation) {
        return fails(reason, Optional.empty(), List.of(), explanation, Explored.NOTHING);
    }

    private static Verdict fails(
            String reason,
            Optional<Boolean> simulation,
            List<Moment> trace,
            List<Sentence> explanation,
            Explored explored) {
        return new Verdict(
                Answer.FAILS, reason, simulation, trace, explanation, List.of(), explored);
    }

    /** The same answer with a reason, and a note that tells it. */
    public Verdict because(String why, String note) {
        List<String> more = with(note).notes;
        return new Verdict(answer, why, simulation, trace, explanation, more, explored);
    }

    /** With one more note. */
    public Verdict with(String note) {
        List<String> more = Stream.concat(notes.stream(), Stream.of(note)).toList();
        return new Verdict(answer, reason, simulation, trace, explanation, more, explored);
    }

    /** With notes of what a search did without. */
    Verdict without(TraceInclusion search) {
        List<String> all = new ArrayList<>();
        List<String> parts = search.leftOut();
        if (!parts.isEmpty()) {
            String named = parts.stream().limit(MOST_NAMED).collect(Collectors.joining(", "));
            int others = parts.size() - MOST_NAMED;
            all.add(
                    "left out, since the answer does not depend on it: "
                            + named
                            + (others > 0 ? " and %d more".formatted(others) : ""));
        }
        all.addAll(search.equalParts());
        search.invariant()
                .ifPresent(
                        clauses ->
                                all.add(
                                        PROVED.formatted(
                                                clauses == 1
                                                        ? "one clause"
                                                        : clauses + " clauses")));
        all.addAll(notes);
        return new Verdict(answer, reason, simulation, trace, explanation, all, explored);
    }

    /** Whether there may be a shorter run than the one that is told. */
    public boolean mayBeShorter() {
        return notes.contains(SHORTER);
    }

    /**
     * With a note where the search may have missed a shorter run.
     *
     * @param inputs of the run that is told
     */
    Verdict afterInputs(int inputs, TraceInclusion search) {
        return inputs > 1 && search.missing().isPresent() ? with(SHORTER) : this;
    }

    /** Not even begun. */
    public static Verdict unknown(String reason) {
        return unknown(reason, Explored.NOTHING);
    }

    static Verdict unknown(String reason, Explored explored) {
        List<Sentence> nothing = List.of();
        return new Verdict(
                Answer.UNKNOWN, reason, Optional.empty(), List.of(), nothing, List.of(), explored);
    }
}
