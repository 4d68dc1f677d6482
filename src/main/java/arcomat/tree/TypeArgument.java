package arcomat.tree;

import arcomat.source.Span;

import java.util.Optional;

/** What stands between the angle brackets of a type. */
public sealed interface TypeArgument extends Node {

    record Given(Span span, TypeReference type) implements TypeArgument {}

    /** {@code ?}, {@code ? extends T} or {@code ? super T}. */
    record Wildcard(Span span, boolean upper, Optional<TypeReference> bound)
            implements TypeArgument {}
}
