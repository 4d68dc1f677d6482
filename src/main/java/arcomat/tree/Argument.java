package arcomat.tree;

import arcomat.source.Span;

import java.util.Optional;

/**
 * An argument for a parameter of a component.
 *
 * @param name of the parameter, {@code size = 3}; empty where the place tells which is meant
 */
public record Argument(Span span, Optional<Name> name, Expression value) implements Node {}
