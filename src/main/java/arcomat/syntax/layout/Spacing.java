package arcomat.syntax.layout;

import arcomat.syntax.antlr.ArcomatParser;

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
        return wouldMerge(left.getText(), right.getText())
                || !hugsNext(left) && !hugsPrevious(right);
    }

    private static boolean wouldMerge(String left, String right) {
        char last = left.charAt(left.length() - 1);
        char first = right.charAt(0);
        return MERGING.contains("" + last + first) && !(left + right).equals("..")
                || Character.isJavaIdentifierPart(last) && Character.isJavaIdentifierPart(first);
    }

    private boolean hugsNext(Token token) {
        ParserRuleContext parent = structure.parent(token);
        return switch (token.getText()) {
            case "(", "[", ".", "..", "@", "!", "~" -> true;
            case "{" ->
                    !structure.opensBody(token)
                            && !(parent instanceof ArcomatParser.EnumDefinitionContext);
            case "-", "+" -> isSign(parent);
            case "<" ->
                    isBracket(parent) || parent instanceof ArcomatParser.AssociationArrowContext;
            case "*" -> isRepetition(parent);
            default -> false;
        };
    }

    private boolean hugsPrevious(Token token) {
        ParserRuleContext parent = structure.parent(token);
        return switch (token.getText()) {
            case ")", "]", ",", ";", ".", ".." -> true;
            case "}" ->
                    !structure.closesBody(token)
                            && !(parent instanceof ArcomatParser.EnumDefinitionContext);
            case "(" ->
                    parent instanceof ArcomatParser.ArgumentsContext
                            || parent instanceof ArcomatParser.ComponentArgumentsContext
                            || parent instanceof ArcomatParser.MethodParametersContext
                            || parent instanceof ArcomatParser.ParametersContext
                            || parent instanceof ArcomatParser.RepeatedGroupContext;
            case "[" ->
                    parent instanceof ArcomatParser.TypeSuffixContext
                            || parent instanceof ArcomatParser.SuffixContext
                            || parent instanceof ArcomatParser.CreatorContext
                            || parent instanceof ArcomatParser.PlaceContext
                            || parent instanceof ArcomatParser.SizeContext
                            || parent instanceof ArcomatParser.ParametersContext;
            case ":" -> !(parent instanceof ArcomatParser.ConditionalExpressionContext);
            case "<" -> isTypeBracket(parent);
            case ">" -> isBracket(parent);
            case "++", "--" ->
                    parent instanceof ArcomatParser.ItemContext
                            || parent instanceof ArcomatParser.StepStatementContext;
            case "*" -> isRepetition(parent);
            default -> false;
        };
    }

    private static boolean isSign(ParserRuleContext parent) {
        return parent instanceof ArcomatParser.UnaryExpressionContext
                || parent instanceof ArcomatParser.UnaryOperandContext
                || parent instanceof ArcomatParser.LiteralMessageContext
                || parent instanceof ArcomatParser.NameMessageContext;
    }

    private static boolean isRepetition(ParserRuleContext parent) {
        return parent instanceof ArcomatParser.RepeatedMessageContext
                || parent instanceof ArcomatParser.RepeatedGroupContext;
    }

    private static boolean isTypeBracket(ParserRuleContext parent) {
        return parent instanceof ArcomatParser.TypeArgumentsContext
                || parent instanceof ArcomatParser.TypeParametersContext;
    }

    private static boolean isBracket(ParserRuleContext parent) {
        return isTypeBracket(parent)
                || parent instanceof ArcomatParser.StereotypesContext
                || parent instanceof ArcomatParser.StreamContext;
    }
}
