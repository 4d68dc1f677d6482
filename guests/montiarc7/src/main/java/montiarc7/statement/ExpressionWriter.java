package montiarc7.statement;

import montiarc7.grammar.MontiArc7Parser.BinaryExpressionContext;
import montiarc7.grammar.MontiArc7Parser.BracketExpressionContext;
import montiarc7.grammar.MontiArc7Parser.CallExpressionContext;
import montiarc7.grammar.MontiArc7Parser.CastExpressionContext;
import montiarc7.grammar.MontiArc7Parser.ChoiceExpressionContext;
import montiarc7.grammar.MontiArc7Parser.ExpressionContext;
import montiarc7.grammar.MontiArc7Parser.LiteralExpressionContext;
import montiarc7.grammar.MontiArc7Parser.MemberExpressionContext;
import montiarc7.grammar.MontiArc7Parser.NameExpressionContext;
import montiarc7.grammar.MontiArc7Parser.PrefixExpressionContext;
import montiarc7.source.Lack;

import org.antlr.v4.runtime.ParserRuleContext;

import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;

/** Expressions in Arcomat's words, and which input ports they read. */
public class ExpressionWriter {
    private static final Map<String, String> LIMITS =
            Map.of(
                    "Integer.MAX_VALUE", "2147483647",
                    "Integer.MIN_VALUE", "(-2147483647 - 1)",
                    "Long.MAX_VALUE", "9223372036854775807L",
                    "Long.MIN_VALUE", "(-9223372036854775807L - 1L)");

    private final Scope scope;

    public ExpressionWriter(Scope scope) {
        this.scope = scope;
    }

    public String write(ExpressionContext expression) {
        return new Bits(scope, this).write(expression).orElseGet(() -> plain(expression));
    }

    private String plain(ExpressionContext expression) {
        if (expression instanceof LiteralExpressionContext literal) {
            return literal.getText().equals("null") ? "--" : literal.getText();
        } else if (expression instanceof NameExpressionContext name) {
            return scope.known().text(name.getText()).orElseGet(() -> port(name.getText()));
        } else if (expression instanceof BracketExpressionContext bracket) {
            return "(" + write(bracket.expression()) + ")";
        } else if (expression instanceof PrefixExpressionContext prefix
                && !prefix.op.getText().equals("~")) {
            return prefix.op.getText() + write(prefix.expression());
        } else if (expression instanceof BinaryExpressionContext binary) {
            return write(binary.expression(0))
                    + " "
                    + binary.op.getText()
                    + " "
                    + write(binary.expression(1));
        } else if (expression instanceof ChoiceExpressionContext choice) {
            return write(choice.expression(0))
                    + " ? "
                    + write(choice.expression(1))
                    + " : "
                    + write(choice.expression(2));
        } else if (expression instanceof CastExpressionContext cast) {
            return "(" + cast.type().getText() + ") " + write(cast.expression());
        } else if (expression instanceof MemberExpressionContext member) {
            return member(member);
        } else if (expression instanceof CallExpressionContext call && isEquals(call)) {
            String left = write(((MemberExpressionContext) call.expression(0)).expression());
            return "(" + left + " == " + write(call.expression(1)) + ")";
        }
        return expression instanceof CallExpressionContext call ? call(call) : unknown(expression);
    }

    /** Java's functions that a choice can say. */
    private String call(CallExpressionContext call) {
        List<String> arguments = call.expression().stream().skip(1).map(this::bracketed).toList();
        String function = call.expression(0).getText() + "/" + arguments.size();
        if (!scope.lacks().hasWholeNumbersOnly()) {
            return unknown(call); // NaN and -0.0 are no matter of a choice
        }
        return switch (function) {
            case "Math.abs/1" -> choice(arguments.get(0), "<", "0", "-" + arguments.get(0));
            case "Math.min/2" -> choice(arguments.get(0), "<=", arguments.get(1), arguments.get(0));
            case "Math.max/2" -> choice(arguments.get(0), ">=", arguments.get(1), arguments.get(0));
            default -> unknown(call);
        };
    }

    private String bracketed(ExpressionContext expression) {
        String text = write(expression);
        return text.matches("\\w+") ? text : "(" + text + ")";
    }

    /** What is compared last is the other way. */
    private static String choice(String left, String operator, String right, String then) {
        String other = right.equals("0") ? left : right;
        return "(%s %s %s ? %s : %s)".formatted(left, operator, right, then, other);
    }

    /** How a name is written. */
    public String port(String name) {
        return name;
    }

    private static boolean isEquals(CallExpressionContext call) {
        return call.expression().size() == 2
                && call.expression(0) instanceof MemberExpressionContext member
                && member.name().getText().equals("equals");
    }

    protected boolean isConstant(MemberExpressionContext member) {
        return scope.types().refersToEnum(member.expression().getText());
    }

    /** A constant of an enum, with the type that it has. */
    protected String member(MemberExpressionContext member) {
        String limit = LIMITS.get(member.getText());
        if (limit != null) {
            return limit;
        }
        String owner = member.expression().getText();
        if (scope.types().refersToEnum(owner)) {
            return owner.substring(owner.lastIndexOf('.') + 1) + "." + member.name().getText();
        }
        if (owner.equals("this")) {
            return member.name().getText();
        }
        return type(member).isPresent() && scope.types().given().stream().noneMatch(this::isObject)
                ? write(member.expression()) + "." + member.name().getText()
                : unknown(member);
    }

    /**
     * The type of what is named, where it is an object of a class diagram or an attribute of one.
     */
    private Optional<String> type(ExpressionContext expression) {
        if (expression instanceof NameExpressionContext) {
            return declared(expression.getText());
        } else if (expression instanceof MemberExpressionContext member) {
            String name = member.name().getText();
            return member.expression().getText().equals("this")
                    ? declared(name)
                    : type(member.expression())
                            .flatMap(each -> scope.types().attribute(each, name));
        }
        return Optional.empty();
    }

    private Optional<String> declared(String name) {
        return Optional.ofNullable(scope.declared().get(name)).map(ParserRuleContext::getText);
    }

    /**
     * Whether a method that gets it may change what is in an object, by this name or another one.
     */
    private boolean isObject(ExpressionContext given) {
        Optional<String> type = type(given);
        boolean isNamed =
                given instanceof NameExpressionContext || given instanceof MemberExpressionContext;
        return isNamed
                && type.map(each -> !scope.types().isValue(each)).orElse(!isConstantText(given));
    }

    /** A constant of an enumeration, or what a class holds. */
    private static boolean isConstantText(ExpressionContext given) {
        return Character.isUpperCase(given.getText().codePointAt(0));
    }

    protected final String unknown(ExpressionContext expression) {
        scope.lacks()
                .missing(
                        Lack.EXPRESSION,
                        expression,
                        "'%s' cannot be said in Arcomat, whose expressions are numbers, truth values and constants; leave what it does to a port"
                                .formatted(expression.getText()));
        return "0";
    }

    /** The input ports that have to carry a message for the expression to have a value. */
    Set<String> reads(ExpressionContext expression) {
        Set<String> names = new HashSet<>();
        collect(expression, names);
        return names;
    }

    private void collect(ExpressionContext expression, Set<String> names) {
        if (expression instanceof NameExpressionContext name) {
            if (scope.inputs().contains(name.getText())) {
                names.add(name.getText());
            }
        } else if (silence(expression) == null) {
            for (var child : expression.children) {
                if (child instanceof ExpressionContext inner) {
                    collect(inner, names);
                }
            }
        }
    }

    /** No message, or an empty list of them. */
    static boolean isNothing(ExpressionContext expression) {
        return expression.getText().equals("null") || expression.getText().equals("[]");
    }

    /**
     * The port that a comparison asks for silence, or for a message; null where it asks neither.
     */
    static String silence(ExpressionContext expression) {
        if (expression instanceof BinaryExpressionContext binary
                && binary.op.getText().matches("[!=]=")) {
            if (isNothing(binary.expression(1))) {
                return binary.expression(0).getText();
            }
            if (isNothing(binary.expression(0))) {
                return binary.expression(1).getText();
            }
        }
        return null;
    }
}
