package arcomat.diagram;

import arcomat.model.Automaton;
import arcomat.model.Expression;
import arcomat.model.Expression.BinaryOperator;
import arcomat.model.Type;

import java.util.List;
import java.util.stream.Collectors;

/** Expressions as models write them, with no more parentheses than needed. */
final class ExpressionText {
    private static final int CONDITIONAL = 0;
    private static final int UNARY = 9;
    private static final int ATOM = 10;

    private ExpressionText() {}

    public static String of(Expression expression) {
        if (expression instanceof Expression.Constant constant) {
            return constant.value().toString();
        }
        if (expression instanceof Expression.PortRead read) {
            return read.port().name();
        }
        if (expression instanceof Expression.VariableRead read) {
            return read.variable().name();
        }
        if (expression instanceof Expression.ParameterRead read) {
            return read.parameter().name();
        }
        if (expression instanceof Expression.AttributeRead read) {
            return within(read.object(), ATOM) + "." + attribute(read);
        }
        if (expression instanceof Expression.PortMatches matches) {
            return matches(matches);
        }
        if (expression instanceof Expression.Unary unary) {
            return sign(unary.operator()) + within(unary.operand(), UNARY);
        }
        if (expression instanceof Expression.Binary binary) {
            int level = level(binary.operator());
            String left = within(binary.left(), level);
            return left + " " + binary.operator().sign() + " " + within(binary.right(), level + 1);
        }
        if (expression instanceof Expression.Conditional choice) {
            return within(choice.condition(), CONDITIONAL + 1)
                    + " ? "
                    + of(choice.then())
                    + " : "
                    + of(choice.otherwise());
        }
        if (expression instanceof Expression.IsIn isIn) {
            return within(isIn.element(), level(BinaryOperator.EQUAL)) + " isin " + set(isIn.set());
        }
        if (expression instanceof Expression.Cast cast) {
            return of(cast.operand(), cast.type());
        }
        throw new AssertionError(expression);
    }

    /** Conversions that nobody wrote are not shown: they lose nothing. */
    private static String of(Expression operand, Type type) {
        boolean narrower = !(type instanceof Type.RealType);
        return narrower ? "(" + type.name() + ") " + within(operand, UNARY) : of(operand);
    }

    private static String within(Expression expression, int level) {
        String text = of(expression);
        return levelOf(expression) < level ? "(" + text + ")" : text;
    }

    private static String attribute(Expression.AttributeRead read) {
        Type type = read.object().type();
        return type instanceof Type.ClassType object
                ? object.attributes().get(read.index()).name()
                : String.valueOf(read.index());
    }

    private static String matches(Expression.PortMatches matches) {
        return item(matches.port().name(), matches.pattern());
    }

    /** What is asked of a port. */
    static String item(String port, Automaton.Pattern pattern) {
        if (pattern instanceof Automaton.Absent) {
            return port + " == --";
        }
        if (pattern instanceof Automaton.Present) {
            return port + " == ?";
        }
        List<Expression> values = ((Automaton.OneOf) pattern).values();
        return values.size() == 1
                ? port + " == " + of(values.get(0))
                : port + " isin " + set(values);
    }

    private static String set(List<Expression> values) {
        return values.stream().map(ExpressionText::of).collect(Collectors.joining(", ", "{", "}"));
    }

    private static int levelOf(Expression expression) {
        if (expression instanceof Expression.Binary binary) {
            return level(binary.operator());
        }
        if (expression instanceof Expression.Conditional) {
            return CONDITIONAL;
        }
        if (expression instanceof Expression.IsIn || expression instanceof Expression.PortMatches) {
            return level(BinaryOperator.EQUAL);
        }
        if (expression instanceof Expression.Unary) {
            return UNARY;
        }
        if (expression instanceof Expression.Cast cast) {
            return cast.type() instanceof Type.RealType ? levelOf(cast.operand()) : UNARY;
        }
        return ATOM;
    }

    private static int level(BinaryOperator operator) {
        return switch (operator) {
            case EQUIVALENT -> 1;
            case IMPLIES -> 2;
            case OR -> 3;
            case AND -> 4;
            case EQUAL, NOT_EQUAL -> 5;
            case LESS, LESS_OR_EQUAL, GREATER, GREATER_OR_EQUAL -> 6;
            case PLUS, MINUS -> 7;
            case MULTIPLY, DIVIDE, REMAINDER -> 8;
        };
    }

    private static String sign(Expression.UnaryOperator operator) {
        return switch (operator) {
            case NOT -> "!";
            case NEGATE -> "-";
            case COMPLEMENT -> "~";
        };
    }
}
