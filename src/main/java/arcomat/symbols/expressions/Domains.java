package arcomat.symbols.expressions;

import static arcomat.symbols.expressions.Problems.quoted;

import arcomat.source.ArrayNames;
import arcomat.symbols.expressions.ExpressionProblem.Kind;
import arcomat.symbols.names.BuiltinType;
import arcomat.symbols.names.EnumSymbol;
import arcomat.symbols.names.RangeType;
import arcomat.symbols.names.Resolution;
import arcomat.symbols.names.TypeSymbol;
import arcomat.tree.Expression;
import arcomat.tree.TypeReference;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.function.Function;
import java.util.stream.IntStream;
import java.util.stream.LongStream;

/** The values that a quantifier is about, in their order. */
final class Domains {
    private final ValueScope scope;
    private final Problems problems;
    private final Function<Expression, TypedExpression> typing;

    Domains(ValueScope scope, Problems problems, Function<Expression, TypedExpression> typing) {
        this.scope = scope;
        this.problems = problems;
        this.typing = typing;
    }

    /** Empty where something is wrong, which is told. */
    Optional<List<TypedExpression>> values(Expression.Domain domain) {
        return domain.named().isPresent()
                ? named(domain, domain.named().get())
                : members(domain.members());
    }

    // ---- what is written ------------------------------------------------------------------

    private Optional<List<TypedExpression>> members(List<Expression.Member> members) {
        List<TypedExpression> all = new ArrayList<>();
        boolean known = true;
        for (Expression.Member member : members) {
            Optional<List<TypedExpression>> values =
                    member.high().isPresent() ? range(member, member.high().get()) : single(member);
            known &= values.isPresent();
            values.ifPresent(all::addAll);
        }
        return known ? Optional.of(all) : Optional.empty();
    }

    private Optional<List<TypedExpression>> single(Expression.Member member) {
        TypedExpression value = member(member.low());
        return value.type().isErroneous() ? Optional.empty() : Optional.of(List.of(value));
    }

    private Optional<List<TypedExpression>> range(Expression.Member member, Expression last) {
        TypedExpression low = member(member.low());
        TypedExpression high = member(last);
        Optional<Long> from = ConstantFolding.computed(low);
        Optional<Long> to = ConstantFolding.computed(high);
        boolean alike = low.type().base().equals(high.type().base());
        if (from.isPresent() && to.isPresent() && alike) {
            return range(member.low(), low.type().base(), from.get(), to.get());
        }
        if (!low.type().isErroneous() && !high.type().isErroneous()) {
            problems.report(
                    new ExpressionProblem(
                            Kind.DOMAIN,
                            member.span(),
                            "the ends of a range are two whole numbers or two characters that are"
                                    + " known before the run",
                            Optional.empty()));
        }
        return Optional.empty();
    }

    private TypedExpression member(Expression written) {
        TypedExpression value = typing.apply(written);
        problems.unfolding().values().add(value);
        return value;
    }

    private Optional<List<TypedExpression>> range(
            Expression node, TypeSymbol type, long low, long high) {
        if (high - low >= QuantifierTyping.MOST || high < low && low - high < 0) {
            problems.mayGrow(node, Integer.MAX_VALUE);
            return Optional.empty();
        }
        return Optional.of(
                LongStream.rangeClosed(low, high)
                        .mapToObj(value -> number(node, type, value))
                        .toList());
    }

    private static TypedExpression number(Expression node, TypeSymbol type, long value) {
        Object literal = type == BuiltinType.CHARACTER ? (Object) (char) value : (Object) value;
        return new TypedExpression.Literal(node, literal, type);
    }

    // ---- what has a name ------------------------------------------------------------------

    private Optional<List<TypedExpression>> named(Expression.Domain domain, TypeReference named) {
        List<TypedExpression> elements = elements(named);
        if (!elements.isEmpty()) {
            problems.unfolding().values().addAll(elements);
            return Optional.of(elements);
        }
        problems.unfolding().types().add(named);
        Resolution<TypeSymbol> type = scope.type(named);
        Expression place = new Expression.Indexed(domain.span(), List.of());
        if (type.found().isPresent()) {
            return values(place, type.found().get());
        }
        if (!type.isExcused()) {
            problems.report(
                    Kind.UNKNOWN_NAME,
                    place,
                    "there is no array and no type %s".formatted(quoted(place)));
        }
        return Optional.empty();
    }

    /** Of an array, each is read at the place where the whole is named. */
    private List<TypedExpression> elements(TypeReference named) {
        if (!named.arguments().isEmpty() || named.range().isPresent() || named.dimensions() > 0) {
            return List.of();
        }
        String array = named.name().text();
        Expression.Reference place = new Expression.Reference(named.span(), named.name());
        return IntStream.range(0, ArrayNames.MOST)
                .mapToObj(index -> scope.value(ArrayNames.element(array, index)))
                .takeWhile(Optional::isPresent)
                .map(each -> each.get().read(place))
                .toList();
    }

    private Optional<List<TypedExpression>> values(Expression place, TypeSymbol type) {
        if (type instanceof EnumSymbol symbol) {
            return Optional.of(
                    IntStream.range(0, symbol.constants().size())
                            .<TypedExpression>mapToObj(
                                    each -> new TypedExpression.Constant(place, symbol, each, true))
                            .toList());
        }
        if (type == BuiltinType.BOOLEAN) {
            return Optional.of(
                    List.of(
                            new TypedExpression.Literal(place, false, type),
                            new TypedExpression.Literal(place, true, type)));
        }
        return numbers(place, type);
    }

    private Optional<List<TypedExpression>> numbers(Expression place, TypeSymbol type) {
        if (type instanceof RangeType range) {
            return range(place, range.carrier(), range.low(), range.high());
        }
        if (type instanceof BuiltinType builtin && builtin.isWhole()) {
            return range(place, builtin, builtin.low(), builtin.high());
        }
        if (!type.isErroneous()) {
            problems.report(
                    Kind.DOMAIN,
                    place,
                    "%s is no finite set; name an enumeration, a range or an array"
                            .formatted(quoted(place)));
        }
        return Optional.empty();
    }
}
