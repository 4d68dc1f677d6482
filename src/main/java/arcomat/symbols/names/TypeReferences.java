package arcomat.symbols.names;

import arcomat.tree.Expression;
import arcomat.tree.QualifiedName;
import arcomat.tree.TypeReference;

import java.util.OptionalLong;
import java.util.function.Function;

/** Turns a type as written into a type, once its name can be resolved. */
public final class TypeReferences {
    private TypeReferences() {}

    public static Resolution<TypeSymbol> resolve(
            TypeReference reference, Function<QualifiedName, Resolution<TypeSymbol>> names) {
        if (reference.dimensions() > 0) {
            return resolve(element(reference), names).map(JavaTypes::listOf);
        }
        Resolution<TypeSymbol> named = names.apply(reference.name());
        if (named.found().orElse(null) instanceof JavaType java && reference.range().isEmpty()) {
            return JavaTypes.given(java, reference, names);
        }
        if (named.found().filter(t -> t instanceof UnsupportedType).isPresent()) {
            return named;
        }
        if (!reference.arguments().isEmpty() && named.isFound()) {
            return unsupported(
                    reference, "only components take type arguments; use the type without them");
        }
        if (reference.range().isEmpty() || !named.isFound()) {
            return named;
        }
        return ranged(reference, reference.range().get(), named.found().get());
    }

    /** What an array holds: {@code int[]} for {@code int[][]}. */
    private static TypeReference element(TypeReference array) {
        return new TypeReference(
                array.span(),
                array.name(),
                array.arguments(),
                array.range(),
                array.dimensions() - 1);
    }

    private static Resolution<TypeSymbol> ranged(
            TypeReference reference, TypeReference.Range range, TypeSymbol base) {
        boolean mayHaveRange =
                base instanceof BuiltinType type && type.isWhole() && type != BuiltinType.CHARACTER;
        if (!mayHaveRange) {
            return unsupported(reference, "only whole number types have ranges");
        }
        OptionalLong low = number(range.low());
        OptionalLong high = number(range.high());
        if (low.isEmpty() || high.isEmpty()) {
            return unsupported(reference, "write the ends of a range as whole numbers");
        }
        return new Resolution.Found<>(
                new RangeType((BuiltinType) base, low.getAsLong(), high.getAsLong()));
    }

    private static OptionalLong number(Expression expression) {
        if (expression instanceof Expression.Unary unary
                && unary.operator() == Expression.UnaryOperator.MINUS
                && unary.operand() instanceof Expression.Literal literal) {
            return LiteralValues.wholeNumber(literal, true);
        }
        return expression instanceof Expression.Literal literal
                ? LiteralValues.wholeNumber(literal, false)
                : OptionalLong.empty();
    }

    static Resolution<TypeSymbol> unsupported(TypeReference reference, String advice) {
        return new Resolution.Found<>(new UnsupportedType(reference.span().text(), advice));
    }
}
