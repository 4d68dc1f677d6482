package arcomat.semantics.expression;

import arcomat.model.Automaton;
import arcomat.model.Expression;

import java.util.ArrayList;
import java.util.List;
import java.util.function.Consumer;
import java.util.function.UnaryOperator;

/** Walks over expressions: the one place that knows what every form is made of. */
public final class Rewriting {
    private Rewriting() {}

    /** Rebuilds an expression from its rewritten operands, then rewrites the result itself. */
    public static Expression bottomUp(Expression expression, UnaryOperator<Expression> rule) {
        return rule.apply(withOperands(expression, e -> bottomUp(e, rule)));
    }

    /** Visits an expression and all that it is made of, operands first, from left to right. */
    public static void visit(Expression expression, Consumer<Expression> visitor) {
        withOperands(
                expression,
                operand -> {
                    visit(operand, visitor);
                    return operand;
                });
        visitor.accept(expression);
    }

    /** What an expression is directly made of, from left to right. */
    public static List<Expression> operands(Expression expression) {
        List<Expression> operands = new ArrayList<>();
        withOperands(
                expression,
                operand -> {
                    operands.add(operand);
                    return operand;
                });
        return operands;
    }

    static Expression withOperands(Expression e, UnaryOperator<Expression> rewrite) {
        if (e instanceof Expression.Unary unary) {
            return new Expression.Unary(
                    unary.operator(), rewrite.apply(unary.operand()), unary.type(), unary.span());
        }
        if (e instanceof Expression.Binary binary) {
            return new Expression.Binary(
                    binary.operator(),
                    rewrite.apply(binary.left()),
                    rewrite.apply(binary.right()),
                    binary.type(),
                    binary.span());
        }
        if (e instanceof Expression.Conditional choice) {
            return new Expression.Conditional(
                    rewrite.apply(choice.condition()),
                    rewrite.apply(choice.then()),
                    rewrite.apply(choice.otherwise()),
                    choice.type(),
                    choice.span());
        }
        if (e instanceof Expression.IsIn isIn) {
            return new Expression.IsIn(
                    rewrite.apply(isIn.element()), all(isIn.set(), rewrite), isIn.span());
        }
        if (e instanceof Expression.Cast cast) {
            return new Expression.Cast(rewrite.apply(cast.operand()), cast.type(), cast.span());
        }
        if (e instanceof Expression.AttributeRead read) {
            return new Expression.AttributeRead(
                    rewrite.apply(read.object()), read.index(), read.type(), read.span());
        }
        if (e instanceof Expression.PortMatches matches
                && matches.pattern() instanceof Automaton.OneOf oneOf) {
            return new Expression.PortMatches(
                    matches.port(),
                    new Automaton.OneOf(all(oneOf.values(), rewrite)),
                    matches.span());
        }
        return e;
    }

    private static List<Expression> all(List<Expression> list, UnaryOperator<Expression> rewrite) {
        return list.stream().map(rewrite).toList();
    }
}
