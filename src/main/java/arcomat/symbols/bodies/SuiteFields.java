package arcomat.symbols.bodies;

import arcomat.source.Span;
import arcomat.symbols.expressions.ExpressionTyping;
import arcomat.symbols.expressions.ValueScope;
import arcomat.symbols.expressions.VariableSymbol;
import arcomat.symbols.names.EnumSymbol;
import arcomat.symbols.names.OpaqueSymbol;
import arcomat.symbols.names.Resolution;
import arcomat.symbols.names.TypeSymbol;
import arcomat.tree.Expression;
import arcomat.tree.Name;
import arcomat.tree.TestSuite;
import arcomat.tree.TestSuite.Before;
import arcomat.tree.TestSuite.Field;
import arcomat.tree.Variable;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.regex.Pattern;

/**
 * The fields of a suite whose value is known although nothing is run before its tests. Of an opaque
 * type is any of them: nobody looks into such a message, so that each field stands for one of its
 * own, called like the field.
 */
record SuiteFields(TestSuite suite, ValueScope scope) {

    List<VariableSymbol> known() {
        List<VariableSymbol> known = new ArrayList<>();
        for (TestSuite.Member member : suite.members()) {
            if (member instanceof Field field) {
                Resolution<TypeSymbol> type = scope.type(field.type());
                for (Variable each : field.variables()) {
                    node(each, field, type)
                            .filter(node -> isSole(each))
                            .map(node -> symbol(node, type))
                            .ifPresent(known::add);
                }
            }
        }
        return List.copyOf(known);
    }

    private VariableSymbol symbol(Variable node, Resolution<TypeSymbol> type) {
        return new VariableSymbol(
                VariableSymbol.Kind.SUITE,
                node,
                type,
                (value, expected) -> ExpressionTyping.message(value, scope, expected));
    }

    private Optional<Variable> node(Variable each, Field field, Resolution<TypeSymbol> type) {
        if (isConstant(each, type) && !isTouched(each)) {
            return Optional.of(each);
        }
        return type.found().orElse(null) instanceof OpaqueSymbol && field.type().name().isSimple()
                ? Optional.of(withMessage(each, field.type().name().last()))
                : Optional.empty();
    }

    /** As if the message were written, as {@code Parcel("first")} for {@code first}. */
    private static Variable withMessage(Variable field, Name type) {
        Span span = field.name().span();
        Expression text =
                new Expression.Literal(
                        span, Expression.Literal.Kind.STRING, '"' + field.name().text() + '"');
        Expression message =
                new Expression.Call(
                        span, Optional.empty(), new Name(span, type.text()), List.of(text));
        return new Variable(field.span(), field.name(), Optional.of(message));
    }

    private static boolean isConstant(Variable field, Resolution<TypeSymbol> type) {
        return field.initial()
                .filter(
                        value ->
                                isLiteral(value)
                                        || isConstant(value, type)
                                        || isMessage(value, type)
                                        || type.isExcused() && isNamed(value))
                .isPresent();
    }

    /** {@code Parcel("first")}, or {@code Cup(5)} of what is literal again. */
    private static boolean isMessage(Expression value, Resolution<TypeSymbol> type) {
        return value instanceof Expression.Call call
                && call.target().isEmpty()
                && type.found().filter(each -> call.name().text().equals(each.text())).isPresent()
                && call.arguments().stream().allMatch(SuiteFields::isLiteral);
    }

    /** What it is, only a file with errors tells. */
    private static boolean isNamed(Expression value) {
        return value instanceof Expression.Reference
                || value instanceof Expression.Call call && call.target().isEmpty();
    }

    private static boolean isLiteral(Expression value) {
        Expression number =
                value instanceof Expression.Unary unary
                                && unary.operator() == Expression.UnaryOperator.MINUS
                        ? unary.operand()
                        : value;
        return number instanceof Expression.Literal literal
                && literal.kind() != Expression.Literal.Kind.NULL;
    }

    private static boolean isConstant(Expression value, Resolution<TypeSymbol> type) {
        return value instanceof Expression.Reference reference
                && type.found().orElse(null) instanceof EnumSymbol constants
                && constants.ordinal(reference.name().last().text()).isPresent();
    }

    /** Java may give it another value. */
    private boolean isTouched(Variable field) {
        Pattern name = Pattern.compile("\\b" + Pattern.quote(field.name().text()) + "\\b");
        return suite.members().stream()
                .flatMap(member -> member.before().stream())
                .map(Before::text)
                .anyMatch(text -> name.matcher(text).find());
    }

    private boolean isSole(Variable field) {
        return suite.members().stream()
                        .map(
                                member ->
                                        member instanceof Field of
                                                ? of.variables()
                                                : List.<Variable>of())
                        .flatMap(List::stream)
                        .filter(each -> each.name().text().equals(field.name().text()))
                        .count()
                == 1;
    }
}
