package montiarc7.statement;

import montiarc7.grammar.MontiArc7Parser;
import montiarc7.grammar.MontiArc7Parser.BinaryExpressionContext;
import montiarc7.grammar.MontiArc7Parser.BitExpressionContext;
import montiarc7.grammar.MontiArc7Parser.BracketExpressionContext;
import montiarc7.grammar.MontiArc7Parser.CallExpressionContext;
import montiarc7.grammar.MontiArc7Parser.ExpressionContext;
import montiarc7.grammar.MontiArc7Parser.ListExpressionContext;
import montiarc7.grammar.MontiArc7Parser.LiteralExpressionContext;
import montiarc7.grammar.MontiArc7Parser.MemberExpressionContext;
import montiarc7.grammar.MontiArc7Parser.PrefixExpressionContext;

import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.TreeSet;

/**
 * What follows from guards. In Arcomat a guard that reads a silent port is undefined, and its
 * negation is too; so "not enabled" has to be said of each part, with silence as a way not to be.
 */
public final class Guards {
    private final ExpressionWriter writer;

    public Guards(ExpressionWriter writer) {
        this.writer = writer;
    }

    /**
     * True exactly where an expression is not true, be it false or undefined; said where another
     * one is true.
     *
     * @param own the other one
     * @param present ports that carry a message anyway
     */
    public String notTrue(
            ExpressionContext expression, List<ExpressionContext> own, Set<String> present) {
        Set<String> known = new HashSet<>();
        own.forEach(each -> known.add(key(each)));
        List<String> ways =
                parts(expression).stream()
                        .filter(each -> !known.contains(key(each)))
                        .map(each -> not(each, true, present))
                        .toList();
        return ways.size() == 1 ? ways.get(0) : "(" + String.join(" || ", ways) + ")";
    }

    /** Whether an expression is true wherever another one is. */
    public boolean follows(ExpressionContext expression, ExpressionContext own) {
        List<String> known = parts(own).stream().map(this::key).toList();
        return parts(expression).stream().allMatch(each -> known.contains(key(each)));
    }

    /** The same for what is written in two ways. */
    private String key(ExpressionContext expression) {
        return bare(writer.write(plain(expression)));
    }

    /** Without brackets around the whole. */
    public static String bare(String text) {
        if (!text.startsWith("(") || !text.endsWith(")") || text.matches(".*[\"'].*")) {
            return text;
        }
        int open = 0;
        for (int i = 0; i < text.length() - 1; i++) {
            open += text.charAt(i) == '(' ? 1 : text.charAt(i) == ')' ? -1 : 0;
            if (open == 0) {
                return text;
            }
        }
        return text.substring(1, text.length() - 1);
    }

    private String not(ExpressionContext at, boolean value, Set<String> present) {
        ExpressionContext expression = plain(at);
        if (expression instanceof PrefixExpressionContext prefix
                && prefix.op.getText().equals("!")) {
            return not(prefix.expression(), !value, present);
        }
        if (expression instanceof BinaryExpressionContext binary) {
            String operator = binary.op.getText();
            if (operator.equals("&&") || operator.equals("||")) {
                String by = operator.equals("&&") == value ? " || " : " && ";
                return "("
                        + not(binary.expression(0), value, present)
                        + by
                        + not(binary.expression(1), value, present)
                        + ")";
            }
            if (operator.equals("implies")) {
                String by = value ? " && " : " || ";
                return "("
                        + not(binary.expression(0), !value, present)
                        + by
                        + not(binary.expression(1), value, present)
                        + ")";
            }
        }
        String other = value ? negation(expression) : writer.write(expression);
        StringBuilder text = new StringBuilder();
        for (String port : new TreeSet<>(writer.reads(expression))) {
            if (!present.contains(port)) {
                text.append(writer.port(port)).append(" == -- || ");
            }
        }
        boolean simple = text.isEmpty();
        text.append(other);
        return simple ? text.toString() : "(" + text + ")";
    }

    private String negation(ExpressionContext atom) {
        if (atom instanceof BinaryExpressionContext binary
                && binary.op.getText().matches("[!=]=")) {
            String turned = binary.op.getText().equals("==") ? " != " : " == ";
            return writer.write(binary.expression(0)) + turned + writer.write(binary.expression(1));
        }
        if (atom instanceof CallExpressionContext) {
            return "!" + writer.write(atom);
        }
        if (atom instanceof BinaryExpressionContext) {
            return "!(" + writer.write(atom) + ")";
        }
        return "!" + bracketed(writer.write(atom));
    }

    private static String bracketed(String text) {
        return text.matches("[\\w$.]+") || text.startsWith("(") && text.endsWith(")")
                ? text
                : "(" + text + ")";
    }

    /** Ports that carry a message where the expression is true. */
    public Set<String> presentIn(ExpressionContext expression) {
        Set<String> present = new HashSet<>();
        for (ExpressionContext part : parts(expression)) {
            String asked = ExpressionWriter.silence(part);
            if (asked != null) {
                if (((BinaryExpressionContext) part).op.getText().equals("!=")) {
                    present.add(asked);
                }
            } else if (!isChoice(part)) {
                present.addAll(writer.reads(part));
            }
        }
        return present;
    }

    /** Where a part of an expression may be undefined, and the whole true. */
    private static boolean isChoice(ExpressionContext part) {
        if (plain(part) instanceof PrefixExpressionContext prefix) {
            return isChoice(prefix.expression());
        }
        if (plain(part) instanceof BinaryExpressionContext binary) {
            return binary.op.getText().matches("\\|\\||&&|implies|<=>");
        }
        return plain(part) instanceof BitExpressionContext
                || plain(part) instanceof MontiArc7Parser.ChoiceExpressionContext;
    }

    /** Whether two guards are evidently never true together. */
    public boolean exclude(ExpressionContext one, ExpressionContext other) {
        for (ExpressionContext first : parts(one)) {
            for (ExpressionContext second : parts(other)) {
                if (contradict(first, second) || contradict(second, first)) {
                    return true;
                }
            }
        }
        return false;
    }

    private boolean contradict(ExpressionContext first, ExpressionContext second) {
        String silent = ExpressionWriter.silence(first);
        if (silent != null
                && ((BinaryExpressionContext) first).op.getText().equals("==")
                && (presentIn(second).contains(silent))) {
            return true;
        }
        if (first instanceof PrefixExpressionContext prefix
                && prefix.op.getText().equals("!")
                && plain(prefix.expression()).getText().equals(second.getText())) {
            return true;
        }
        if (first instanceof BinaryExpressionContext a
                && second instanceof BinaryExpressionContext b
                && a.expression(0).getText().equals(b.expression(0).getText())) {
            boolean same = a.expression(1).getText().equals(b.expression(1).getText());
            return switch (a.op.getText() + " " + b.op.getText()) {
                case "== !=", "== <", "== >", "< >", "< >=", "> <=" -> same;
                case "== ==" -> areDifferent(a.expression(1), b.expression(1));
                default -> false;
            };
        }
        return false;
    }

    private boolean areDifferent(ExpressionContext one, ExpressionContext other) {
        Optional<String> first = constant(one);
        Optional<String> second = constant(other);
        return first.isPresent() && second.isPresent() && !first.equals(second);
    }

    /**
     * Of a constant what tells it from others of its type; numbers might be written in two ways.
     */
    private Optional<String> constant(ExpressionContext expression) {
        if (expression instanceof ListExpressionContext list && list.expression().size() == 1) {
            return constant(list.expression(0));
        }
        if (expression instanceof MemberExpressionContext member && writer.isConstant(member)) {
            return Optional.of(member.name().getText());
        }
        return Optional.of(expression.getText())
                .filter(each -> expression instanceof LiteralExpressionContext)
                .filter(each -> each.matches("0|[1-9][0-9]{0,8}|true|false|\"[^\\\\]*\""));
    }

    /** What has to be true together. */
    public static List<ExpressionContext> parts(ExpressionContext at) {
        List<ExpressionContext> parts = new ArrayList<>();
        ExpressionContext expression = plain(at);
        if (expression instanceof BinaryExpressionContext binary
                && binary.op.getText().equals("&&")) {
            parts.addAll(parts(binary.expression(0)));
            parts.addAll(parts(binary.expression(1)));
        } else {
            parts.add(expression);
        }
        return parts;
    }

    private static ExpressionContext plain(ExpressionContext expression) {
        return expression instanceof BracketExpressionContext bracket
                ? plain(bracket.expression())
                : expression;
    }
}
