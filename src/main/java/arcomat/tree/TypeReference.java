package arcomat.tree;

import arcomat.source.Span;

import java.util.List;
import java.util.Optional;

/**
 * A type as written.
 *
 * @param dimensions number of {@code []} behind it
 */
public record TypeReference(
        Span span,
        QualifiedName name,
        List<TypeArgument> arguments,
        Optional<Range> range,
        int dimensions)
        implements Node {
    /** {@code [low .. high]} on an integer type, both ends included. */
    public record Range(Span span, Expression low, Expression high) implements Node {}

    /** What stands between the angle brackets of a type. */
    public sealed interface TypeArgument extends Node {

        record Given(Span span, TypeReference type) implements TypeArgument {}

        /** {@code ?}, {@code ? extends T} or {@code ? super T}. */
        record Wildcard(Span span, boolean upper, Optional<TypeReference> bound)
                implements TypeArgument {}
    }
}
