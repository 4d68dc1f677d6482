package montiarc7;

import montiarc7.MontiArc7Parser.ArgumentContext;
import montiarc7.MontiArc7Parser.ArgumentsContext;
import montiarc7.MontiArc7Parser.BinaryExpressionContext;
import montiarc7.MontiArc7Parser.BracketExpressionContext;
import montiarc7.MontiArc7Parser.ComponentContext;
import montiarc7.MontiArc7Parser.ConstraintElementContext;
import montiarc7.MontiArc7Parser.ExpressionContext;
import montiarc7.MontiArc7Parser.FeatureElementContext;
import montiarc7.MontiArc7Parser.LiteralExpressionContext;
import montiarc7.MontiArc7Parser.MemberExpressionContext;
import montiarc7.MontiArc7Parser.NameExpressionContext;
import montiarc7.MontiArc7Parser.PrefixExpressionContext;

import org.antlr.v4.runtime.ParserRuleContext;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.TreeSet;

/**
 * The features of a component, the conditions about them, and what its constraints choose for its
 * parts: in MontiArc a constraint speaks of features of parts, 'part.f == g', and here an argument
 * of the part says the same.
 */
final class Features {
    private final Set<String> own;
    private final Lacks lacks;
    private final Map<String, Map<String, ExpressionContext>> chosen = new LinkedHashMap<>();

    Features(ComponentContext component, Lacks lacks) {
        this.own = new TreeSet<>(of(component));
        own.addAll(new Switches(component).names());
        this.lacks = lacks;
        for (Placed each : Placed.of(component.element())) {
            if (each.element() instanceof ConstraintElementContext constraint) {
                Guards.parts(constraint.expression()).forEach(this::keepChoice);
            }
        }
    }

    static Set<String> of(ComponentContext component) {
        Set<String> names = new TreeSet<>();
        for (Placed each : Placed.of(component.element())) {
            if (each.element() instanceof FeatureElementContext features) {
                features.name().forEach(name -> names.add(name.getText()));
            }
        }
        return names;
    }

    /** What a part is told, where it has features that its arguments leave open. */
    List<String> arguments(
            String part, ComponentContext type, ArgumentsContext given, ParserRuleContext place) {
        List<String> all = new ArrayList<>();
        for (String feature : of(type)) {
            if (given != null && given.argument().stream().anyMatch(each -> isOf(each, feature))) {
                continue;
            }
            Optional<ExpressionContext> condition =
                    Optional.ofNullable(chosen.getOrDefault(part, Map.of()).get(feature));
            if (condition.isEmpty()) {
                lacks.missing(
                        Lack.VARIABILITY,
                        place,
                        "nothing says whether '%s' has '%s'; write '%s = true', or 'false', or name a feature that decides"
                                .formatted(part, feature, feature));
            }
            condition.ifPresent(each -> all.add(feature + " = " + choice(each)));
        }
        Switches switches = new Switches(type);
        for (String each : new TreeSet<>(switches.names())) {
            switches.value(each, given)
                    .ifPresentOrElse(
                            value -> all.add(each + " = " + condition(value)),
                            () ->
                                    lacks.missing(
                                            Lack.VARIABILITY,
                                            place,
                                            "nothing says what '%s' of '%s' is; give it"
                                                    .formatted(each, part)));
        }
        return all;
    }

    /** Of '!part.f' and 'part.f' what is chosen stands in the constraint itself. */
    private String choice(ExpressionContext expression) {
        if (isOfPart(expression)) {
            return "true";
        }
        return expression instanceof PrefixExpressionContext prefix
                        && isOfPart(bare(prefix.expression()))
                ? "false"
                : condition(expression);
    }

    private static boolean isOf(ArgumentContext argument, String feature) {
        return argument.name() != null && argument.name().getText().equals(feature);
    }

    /** What is left of a constraint when it has chosen features of parts; empty if nothing is. */
    String constraint(ConstraintElementContext constraint) {
        List<String> left =
                Guards.parts(constraint.expression()).stream()
                        .filter(each -> ofPart(each).isEmpty())
                        .map(this::condition)
                        .toList();
        return left.isEmpty() ? "" : "constraint (" + String.join(" && ", left) + ");\n";
    }

    private void keepChoice(ExpressionContext part) {
        ofPart(part)
                .ifPresent(
                        member ->
                                chosen.computeIfAbsent(
                                                member.expression().getText(),
                                                each -> new LinkedHashMap<>())
                                        .putIfAbsent(member.name().getText(), value(part)));
    }

    /** The feature of a part that an equation, or the feature alone, chooses. */
    private Optional<MemberExpressionContext> ofPart(ExpressionContext at) {
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

    private static boolean isOfPart(ExpressionContext expression) {
        return expression instanceof MemberExpressionContext member
                && member.expression() instanceof NameExpressionContext;
    }

    private static ExpressionContext bare(ExpressionContext expression) {
        return expression instanceof BracketExpressionContext bracket
                ? bare(bracket.expression())
                : expression;
    }

    /** A condition, of features and nothing else. */
    String condition(ExpressionContext expression) {
        if (expression instanceof BracketExpressionContext bracket) {
            return "(" + condition(bracket.expression()) + ")";
        } else if (expression instanceof PrefixExpressionContext prefix
                && prefix.op.getText().equals("!")) {
            return "!" + condition(prefix.expression());
        } else if (expression instanceof BinaryExpressionContext binary) {
            return both(binary);
        } else if (expression instanceof LiteralExpressionContext
                && expression.getText().matches("true|false")) {
            return expression.getText();
        } else if (own.contains(expression.getText())) {
            return expression.getText();
        }
        return unknown(expression);
    }

    private String both(BinaryExpressionContext binary) {
        String operator = binary.op.getText();
        if (!operator.matches("&&|\\|\\||implies|<=>|==|!=")) {
            return unknown(binary);
        }
        String left = condition(binary.expression(0));
        String right = condition(binary.expression(1));
        return switch (operator) {
            case "==" -> "(" + left + " <=> " + right + ")";
            case "!=" -> "!(" + left + " <=> " + right + ")";
            default -> left + " " + operator + " " + right;
        };
    }

    private String unknown(ExpressionContext expression) {
        lacks.missing(
                Lack.VARIABILITY,
                expression,
                "'%s' is no feature of this component; conditions of Arcomat speak of features, which are chosen before anything runs"
                        .formatted(expression.getText()));
        return "true";
    }
}
