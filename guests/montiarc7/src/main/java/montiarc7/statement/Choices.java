package montiarc7.statement;

import montiarc7.grammar.MontiArc7Parser.BinaryExpressionContext;
import montiarc7.grammar.MontiArc7Parser.BracketExpressionContext;
import montiarc7.grammar.MontiArc7Parser.ComponentContext;
import montiarc7.grammar.MontiArc7Parser.ConstraintElementContext;
import montiarc7.grammar.MontiArc7Parser.ExpressionContext;
import montiarc7.grammar.MontiArc7Parser.MemberExpressionContext;
import montiarc7.grammar.MontiArc7Parser.NameExpressionContext;
import montiarc7.grammar.MontiArc7Parser.PrefixExpressionContext;
import montiarc7.source.Placed;

import java.util.LinkedHashMap;
import java.util.Map;
import java.util.Optional;

/**
 * What the constraints of a component choose for its parts: in MontiArc a constraint speaks of
 * features of parts, 'part.f == g', and here an argument of the part says the same.
 */
public final class Choices {
    private final Map<String, ExpressionContext> chosen = new LinkedHashMap<>();

    public Choices(ComponentContext component) {
        for (Placed each : Placed.of(component.element())) {
            if (each.element() instanceof ConstraintElementContext constraint) {
                Guards.parts(constraint.expression()).forEach(this::keep);
            }
        }
    }

    private void keep(ExpressionContext part) {
        ofPart(part).ifPresent(member -> chosen.putIfAbsent(member.getText(), value(part)));
    }

    /** What chooses a feature of a part. */
    public Optional<ExpressionContext> of(String part, String feature) {
        return Optional.ofNullable(chosen.get(part + "." + feature));
    }

    /** The feature of a part that an equation, or the feature alone, chooses. */
    public static Optional<MemberExpressionContext> ofPart(ExpressionContext at) {
        ExpressionContext expression = bare(at);
        if (expression instanceof PrefixExpressionContext prefix
                && prefix.op.getText().equals("!")) {
            expression = bare(prefix.expression());
        } else if (isEquation(expression)) {
            BinaryExpressionContext equal = (BinaryExpressionContext) expression;
            ExpressionContext left = bare(equal.expression(0));
            expression = isOfPart(left) ? left : bare(equal.expression(1));
        }
        return isOfPart(expression)
                ? Optional.of((MemberExpressionContext) expression)
                : Optional.empty();
    }

    private static ExpressionContext value(ExpressionContext at) {
        ExpressionContext expression = bare(at);
        if (!isEquation(expression)) {
            return expression;
        }
        BinaryExpressionContext equal = (BinaryExpressionContext) expression;
        return isOfPart(bare(equal.expression(0))) ? equal.expression(1) : equal.expression(0);
    }

    private static boolean isEquation(ExpressionContext expression) {
        return expression instanceof BinaryExpressionContext binary
                && binary.op.getText().matches("==|<=>");
    }

    public static boolean isOfPart(ExpressionContext expression) {
        return expression instanceof MemberExpressionContext member
                && member.expression() instanceof NameExpressionContext;
    }

    public static ExpressionContext bare(ExpressionContext expression) {
        return expression instanceof BracketExpressionContext bracket
                ? bare(bracket.expression())
                : expression;
    }
}
