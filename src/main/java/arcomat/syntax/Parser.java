package arcomat.syntax;

import arcomat.source.SourceFile;
import arcomat.syntax.Reading.Leaves;
import arcomat.syntax.build.UnitBuilder;
import arcomat.tree.Recovered;
import arcomat.tree.Unit;

import java.util.List;
import java.util.Objects;
import java.util.Optional;
import java.util.function.Supplier;

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
     * The same on the caller's stack, for where there are no threads, as in a browser: what is
     * nested deeply may not fit.
     */
    public static Parsed parseHere(SourceFile file) {
        return Reading.use(file, Leaves.OMITTED, Supplier::get, Parser::parsed);
    }

    private static Parsed parsed(Reading reading) {
        if (!reading.findings().isEmpty()) {
            return new Parsed(Optional.empty(), recovered(reading), reading.findings());
        }
        return new Parsed(Optional.of(unit(reading)), Optional.empty(), List.of());
    }

    private static Optional<Recovered> recovered(Reading reading) {
        if (reading.root() == null || !UnclosedBrace.areBalanced(reading.tokens())) {
            return Optional.empty();
        }
        return Gaps.takeFrom(reading.root(), reading.file())
                .map(gaps -> new Recovered(unit(reading), gaps));
    }

    private static Unit unit(Reading reading) {
        return UnitBuilder.unit(
                reading.file(),
                Objects.requireNonNull(reading.root()),
                reading.tokens().getTokens(),
                reading.comments());
    }
}
