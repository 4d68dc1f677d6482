package montiarc7.statement;

import montiarc7.grammar.MontiArc7Parser.BinaryExpressionContext;
import montiarc7.grammar.MontiArc7Parser.BitExpressionContext;
import montiarc7.grammar.MontiArc7Parser.BracketExpressionContext;
import montiarc7.grammar.MontiArc7Parser.CallExpressionContext;
import montiarc7.grammar.MontiArc7Parser.CastExpressionContext;
import montiarc7.grammar.MontiArc7Parser.ChoiceExpressionContext;
import montiarc7.grammar.MontiArc7Parser.ExpressionContext;
import montiarc7.grammar.MontiArc7Parser.LiteralExpressionContext;
import montiarc7.grammar.MontiArc7Parser.NameExpressionContext;
import montiarc7.grammar.MontiArc7Parser.PrefixExpressionContext;
import montiarc7.grammar.MontiArc7Parser.ShiftExpressionContext;
import montiarc7.grammar.MontiArc7Parser.TypeContext;

import java.util.List;

/** Of which kind the value of an expression is in Java: how many bits a number has. */
final class Kinds {
    enum Kind {
        TRUTH,
        INT,
        LONG,
        OTHER;

        boolean isWhole() {
            return this == INT || this == LONG;
        }

        int bits() {
            return this == LONG ? 64 : 32;
        }

        /** Java makes the smaller number a larger one. */
        private Kind with(Kind other) {
            if (!isWhole() || !other.isWhole()) {
                return OTHER;
            }
            return this == LONG ? this : other;
        }
    }

    private final Scope scope;

    Kinds(Scope scope) {
        this.scope = scope;
    }

    Kind of(ExpressionContext expression) {
        if (expression instanceof LiteralExpressionContext) {
            return literal(expression.getText());
        } else if (expression instanceof NameExpressionContext) {
            return ofType(scope.declared().get(expression.getText()));
        } else if (expression instanceof BracketExpressionContext bracket) {
            return of(bracket.expression());
        } else if (expression instanceof PrefixExpressionContext prefix) {
            return of(prefix.expression());
        } else if (expression instanceof CastExpressionContext cast) {
            return ofType(cast.type());
        } else if (expression instanceof ShiftExpressionContext shift) {
            return of(shift.expression(0));
        } else if (expression instanceof BitExpressionContext bits) {
            return both(bits.expression());
        } else if (expression instanceof ChoiceExpressionContext choice) {
            return both(choice.expression().subList(1, 3));
        } else if (expression instanceof BinaryExpressionContext binary) {
            return binary.op.getText().matches("[-+*/%]") ? both(binary.expression()) : Kind.TRUTH;
        } else if (expression instanceof CallExpressionContext call
                && call.expression(0).getText().matches("Math\\.(abs|min|max)")) {
            List<ExpressionContext> arguments = call.expression();
            return both(arguments.subList(1, arguments.size()));
        }
        return Kind.OTHER;
    }

    private Kind both(List<ExpressionContext> parts) {
        List<Kind> kinds = parts.stream().map(this::of).distinct().toList();
        return kinds.size() == 1 ? kinds.get(0) : kinds.stream().reduce(Kind.INT, Kind::with);
    }

    private static Kind literal(String text) {
        if (text.matches("true|false")) {
            return Kind.TRUTH;
        } else if (text.matches("[0-9]+")) {
            return Kind.INT;
        }
        return text.matches("[0-9]+[lL]") ? Kind.LONG : Kind.OTHER;
    }

    private static Kind ofType(TypeContext type) {
        String text = type == null ? "" : type.getText();
        return switch (text) {
            case "boolean", "Boolean" -> Kind.TRUTH;
            case "byte", "Byte", "short", "Short", "char", "Character", "int", "Integer" ->
                    Kind.INT;
            case "long", "Long" -> Kind.LONG;
            default -> Kind.OTHER;
        };
    }
}
