package arcomat.syntax.layout;

import arcomat.syntax.antlr.ArcomatParser;
import arcomat.syntax.antlr.ArcomatParser.ConditionalExpressionContext;
import arcomat.syntax.antlr.ArcomatParser.EnumDefinitionContext;
import arcomat.syntax.antlr.ArcomatParser.IncrementItemContext;
import arcomat.syntax.antlr.ArcomatParser.LiteralMessageContext;
import arcomat.syntax.antlr.ArcomatParser.NameMessageContext;
import arcomat.syntax.antlr.ArcomatParser.RepeatedGroupContext;
import arcomat.syntax.antlr.ArcomatParser.RepeatedMessageContext;
import arcomat.syntax.antlr.ArcomatParser.UnaryExpressionContext;
import arcomat.syntax.antlr.ArcomatParser.UnaryOperandContext;

import org.antlr.v4.runtime.ParserRuleContext;
import org.antlr.v4.runtime.Token;

import java.util.Set;

/** Whether a space stands between two tokens of a line. */
final class Spacing {
    /** Pairs of characters that would be read as one token, were there no space. */
    private static final Set<String> MERGING =
            Set.of("--", "++", "->", "<=", ">=", "=>", "==", "!=", "&&", "||", "..", "//", "/*");

    private final Structure structure;

    Spacing(Structure structure) {
        this.structure = structure;
    }

    boolean isNeeded(Token left, Token right) {
        return wouldMerge(left.getText(), right.getText()) || isWanted(left, right);
    }

    private static boolean wouldMerge(String left, String right) {
        char last = left.charAt(left.length() - 1);
        char first = right.charAt(0);
        return MERGING.contains("" + last + first) && !(left + right).equals("..")
                || Character.isJavaIdentifierPart(last) && Character.isJavaIdentifierPart(first);
    }

    private boolean isWanted(Token left, Token right) {
        return !hugsNext(left) && !hugsPrevious(right);
    }

    private boolean hugsNext(Token token) {
        ParserRuleContext parent = structure.parent(token);
        return switch (token.getText()) {
            case "(", "[", ".", "..", "@", "!", "~" -> true;
            case "{" -> !structure.opensBody(token) && !(parent instanceof EnumDefinitionContext);
            case "-", "+" -> isSign(parent);
            case "<" -> isBracket(parent);
            case "*" -> isRepetition(parent);
            default -> false;
        };
    }

    private boolean hugsPrevious(Token token) {
        ParserRuleContext parent = structure.parent(token);
        return switch (token.getText()) {
            case ")", "]", ",", ";", ".", ".." -> true;
            case "}" -> !structure.closesBody(token) && !(parent instanceof EnumDefinitionContext);
            case "(" ->
                    isRule(parent, ArcomatParser.RULE_arguments)
                            || isRule(parent, ArcomatParser.RULE_parameters)
                            || parent instanceof RepeatedGroupContext;
            case "[" ->
                    isRule(parent, ArcomatParser.RULE_typeSuffix)
                            || isRule(parent, ArcomatParser.RULE_suffix)
                            || isRule(parent, ArcomatParser.RULE_creator)
                            || isRule(parent, ArcomatParser.RULE_parameters);
            case ":" -> !(parent instanceof ConditionalExpressionContext);
            case "<" -> isTypeBracket(parent);
            case ">" -> isBracket(parent);
            case "++", "--" -> parent instanceof IncrementItemContext;
            case "*" -> isRepetition(parent);
            default -> false;
        };
    }

    private static boolean isSign(ParserRuleContext parent) {
        return parent instanceof UnaryExpressionContext
                || parent instanceof UnaryOperandContext
                || parent instanceof LiteralMessageContext
                || parent instanceof NameMessageContext;
    }

    private static boolean isRepetition(ParserRuleContext parent) {
        return parent instanceof RepeatedMessageContext || parent instanceof RepeatedGroupContext;
    }

    private static boolean isTypeBracket(ParserRuleContext parent) {
        return isRule(parent, ArcomatParser.RULE_typeArguments)
                || isRule(parent, ArcomatParser.RULE_typeParameters);
    }

    private static boolean isBracket(ParserRuleContext parent) {
        return isTypeBracket(parent)
                || isRule(parent, ArcomatParser.RULE_stereotypes)
                || isRule(parent, ArcomatParser.RULE_stream);
    }

    private static boolean isRule(ParserRuleContext context, int rule) {
        return context != null && context.getRuleIndex() == rule;
    }
}
