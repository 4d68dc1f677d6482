package arcomat.model;

import arcomat.model.Expression.BinaryOperator;

import java.util.List;
import java.util.stream.Collectors;

/** Expressions as models write them, with no more parentheses than needed. */
public final class ExpressionText implements Expression.Cases<ExpressionText.Written> {
    private static final int CONDITIONAL = 0;
    private static final int UNARY = 9;
    private static final int ATOM = 10;

    private static final ExpressionText FORMS = new ExpressionText();

    private ExpressionText() {}

    /**
     * An expression in writing.
     *
     * @param level how strongly it binds: what binds more weakly than its place asks is in
     *     parentheses
     */
    public record Written(String text, int level) {
        private String within(int least) {
            return level < least ? "(" + text + ")" : text;
        }
    }

    /** An expression in one line. */
    public static String of(Expression expression) {
        return expression.match(FORMS).text;
    }

    private static String within(Expression expression, int level) {
        return expression.match(FORMS).within(level);
    }

    private static Written atom(String text) {
        return new Written(text, ATOM);
    }

    @Override
    public Written constant(Expression.Constant constant) {
        return atom(constant.value().toString());
    }

    @Override
    public Written portRead(Expression.PortRead read) {
        return atom(read.port().name());
    }

    @Override
    public Written variableRead(Expression.VariableRead read) {
        return atom(read.variable().name());
    }

    @Override
    public Written parameterRead(Expression.ParameterRead read) {
        return atom(read.parameter().name());
    }

    @Override
    public Written attributeRead(Expression.AttributeRead read) {
        return atom(within(read.object(), ATOM) + "." + attribute(read));
    }

    @Override
    public Written portMatches(Expression.PortMatches matches) {
        return new Written(
                item(matches.port().name(), matches.pattern()), level(BinaryOperator.EQUAL));
    }

    @Override
    public Written unary(Expression.Unary unary) {
        return new Written(sign(unary.operator()) + within(unary.operand(), UNARY), UNARY);
    }

    @Override
    public Written binary(Expression.Binary binary) {
        return joined(binary.operator(), binary.left().match(FORMS), binary.right().match(FORMS));
    }

    private static Written joined(BinaryOperator operator, Written left, Written right) {
        int level = level(operator);
        String text = left.within(level) + " " + operator.sign() + " " + right.within(level + 1);
        return new Written(text, level);
    }

    @Override
    public Written conditional(Expression.Conditional choice) {
        return chosen(
                choice.condition().match(FORMS),
                choice.then().match(FORMS),
                choice.otherwise().match(FORMS));
    }

    private static Written chosen(Written condition, Written then, Written otherwise) {
        String decides = condition.within(CONDITIONAL + 1);
        return new Written(decides + " ? " + then.text + " : " + otherwise.text, CONDITIONAL);
    }

    @Override
    public Written isIn(Expression.IsIn isIn) {
        int level = level(BinaryOperator.EQUAL);
        return new Written(within(isIn.element(), level) + " isin " + set(isIn.set()), level);
    }

    /** Conversions that nobody wrote are not shown: they lose nothing. */
    @Override
    public Written cast(Expression.Cast cast) {
        return cast.type() instanceof Type.RealType
                ? cast.operand().match(FORMS)
                : new Written(
                        "(" + cast.type().name() + ") " + within(cast.operand(), UNARY), UNARY);
    }

    /** The condition itself: that it is true is what a condition says. */
    @Override
    public Written judged(Expression.Judged judged) {
        return judged.valuation().fold(new Judging());
    }

    private static final class Judging implements Valuation.Cases<Written> {
        @Override
        public Written part(Valuation.Part part) {
            return part.value().match(FORMS);
        }

        @Override
        public Written not(Written operand) {
            return new Written("!" + operand.within(UNARY), UNARY);
        }

        @Override
        public Written row(boolean all, Written left, Written right) {
            return joined(all ? BinaryOperator.AND : BinaryOperator.OR, left, right);
        }

        @Override
        public Written comparison(boolean equal, Written left, Written right) {
            return joined(equal ? BinaryOperator.EQUAL : BinaryOperator.NOT_EQUAL, left, right);
        }

        @Override
        public Written choice(Written condition, Written then, Written otherwise) {
            return chosen(condition, then, otherwise);
        }
    }

    private static String attribute(Expression.AttributeRead read) {
        Type type = read.object().type();
        return type instanceof Type.ClassType object
                ? object.attributes().get(read.index()).name()
                : String.valueOf(read.index());
    }

    /** What is asked of a port. */
    public static String item(String port, Automaton.Pattern pattern) {
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
