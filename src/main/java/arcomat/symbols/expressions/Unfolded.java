package arcomat.symbols.expressions;

import arcomat.source.Span;
import arcomat.tree.Expression;
import arcomat.tree.Name;
import arcomat.tree.TypeReference;

import java.util.List;

/**
 * What is written in an expression and in none of its typed parts, since it is known before a run:
 * numbers of elements, and what quantifiers and {@code let} are short for. May have something
 * several times, once for each value of a quantifier around it.
 *
 * @param values such as numbers of elements, and members of sets
 * @param types that quantifiers are about
 * @param names that are given to values
 * @param reads of these names
 */
public record Unfolded(
        List<TypedExpression> values,
        List<TypeReference> types,
        List<Bound> names,
        List<Read> reads) {
    static final Unfolded NOTHING = new Unfolded(List.of(), List.of(), List.of(), List.of());

    /**
     * A name for a value.
     *
     * @param giver the quantifier, or {@code let}
     * @param source the set whose values it has, or the value
     */
    public record Bound(Name name, Expression giver, Span source) {}

    public record Read(Bound bound, Span place) {}
}
