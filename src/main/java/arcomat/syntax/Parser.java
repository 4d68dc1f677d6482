package arcomat.syntax;

import arcomat.source.SourceFile;
import arcomat.source.Span;
import arcomat.syntax.Reading.Leaves;
import arcomat.syntax.build.UnitBuilder;
import arcomat.tree.Recovered;
import arcomat.tree.Unit;

import java.util.List;
import java.util.Objects;
import java.util.Optional;
import java.util.function.Supplier;
import java.util.function.UnaryOperator;

/**
 * Reads a file into a tree. The ending of its path tells the language: {@code .cd} is a class
 * diagram, {@code .mt} a suite of stream tests, {@code .ioautomaton} a bare automaton, everything
 * else a component or a bare automaton.
 */
public final class Parser {
    private Parser() {}

    public static Parsed parse(SourceFile file) {
        return Reading.use(file, Leaves.OMITTED, Parser::parsed);
    }

    /**
     * The same on the caller's stack, for where there are no threads, as in a browser: less may be
     * nested, so that it fits.
     */
    public static Parsed parseHere(SourceFile file) {
        return Reading.use(
                file,
                Leaves.OMITTED,
                NestingGuard.LIMIT_OF_SMALL_STACK,
                Supplier::get,
                Parser::parsed);
    }

    /**
     * What somebody has translated, and what of it stands elsewhere.
     *
     * @param written with places in the translation
     * @param placed the same, with the places that it comes from
     */
    public record Translated(Unit written, Unit placed) {}

    /**
     * A text that was made of another one. Nothing where it has errors: {@link #parse} tells them.
     *
     * @param places where what stands in it comes from
     */
    public static Optional<Translated> parse(SourceFile file, UnaryOperator<Span> places) {
        return Reading.use(file, Leaves.OMITTED, reading -> translated(reading, places));
    }

    /** The same on the caller's stack. */
    public static Optional<Translated> parseHere(SourceFile file, UnaryOperator<Span> places) {
        return Reading.use(
                file,
                Leaves.OMITTED,
                NestingGuard.LIMIT,
                Supplier::get,
                reading -> translated(reading, places));
    }

    private static Optional<Translated> translated(Reading reading, UnaryOperator<Span> places) {
        return reading.findings().isEmpty()
                ? Optional.of(
                        new Translated(
                                unit(reading, List.of(), UnaryOperator.identity()),
                                unit(reading, List.of(), places)))
                : Optional.empty();
    }

    private static Parsed parsed(Reading reading) {
        if (!reading.findings().isEmpty()) {
            return new Parsed(Optional.empty(), recovered(reading), reading.findings());
        }
        Unit unit = unit(reading, List.of(), UnaryOperator.identity());
        return new Parsed(Optional.of(unit), Optional.empty(), List.of());
    }

    private static Optional<Recovered> recovered(Reading reading) {
        if (reading.root() == null || !UnclosedBrace.areBalanced(reading.tokens())) {
            return Optional.empty();
        }
        return Gaps.takeFrom(reading.root(), reading.file())
                .map(gaps -> new Recovered(unit(reading, gaps, UnaryOperator.identity()), gaps));
    }

    private static Unit unit(Reading reading, List<Span> gaps, UnaryOperator<Span> places) {
        return UnitBuilder.unit(
                reading.file(),
                Objects.requireNonNull(reading.root()),
                reading.tokens().getTokens(),
                reading.comments(),
                gaps,
                places);
    }
}
