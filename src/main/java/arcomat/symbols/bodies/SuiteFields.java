package arcomat.symbols.bodies;

import arcomat.symbols.expressions.ExpressionTyping;
import arcomat.symbols.expressions.ValueScope;
import arcomat.symbols.expressions.VariableSymbol;
import arcomat.symbols.names.EnumSymbol;
import arcomat.symbols.names.Resolution;
import arcomat.symbols.names.TypeSymbol;
import arcomat.tree.Expression;
import arcomat.tree.TestSuite;
import arcomat.tree.TestSuite.Before;
import arcomat.tree.TestSuite.Field;
import arcomat.tree.Variable;

import java.util.ArrayList;
import java.util.List;
import java.util.regex.Pattern;

/** The fields of a suite whose value is known although nothing is run before its tests. */
record SuiteFields(TestSuite suite, ValueScope scope) {

    List<VariableSymbol> known() {
        List<VariableSymbol> known = new ArrayList<>();
        for (TestSuite.Member member : suite.members()) {
            if (member instanceof Field field) {
                Resolution<TypeSymbol> type = scope.type(field.type());
                for (Variable each : field.variables()) {
                    if (isConstant(each, type) && !isTouched(each) && isSole(each)) {
                        known.add(
                                new VariableSymbol(
                                        VariableSymbol.Kind.SUITE,
                                        each,
                                        type,
                                        ExpressionTyping.at(scope)));
                    }
                }
            }
        }
        return List.copyOf(known);
    }

    private static boolean isConstant(Variable field, Resolution<TypeSymbol> type) {
        return field.initial()
                .filter(value -> isLiteral(value) || isConstant(value, type))
                .isPresent();
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
