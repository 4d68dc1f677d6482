package arcomat.syntax.build;

import arcomat.syntax.antlr.ArcomatLexer;
import arcomat.tree.Expression.Literal.Kind;

import org.antlr.v4.runtime.Token;

/** From tokens to kinds of literals. */
final class Literals {
    private Literals() {}

    static Kind kindOf(Token token) {
        return switch (token.getType()) {
            case ArcomatLexer.INT -> Kind.INT;
            case ArcomatLexer.LONG -> Kind.LONG;
            case ArcomatLexer.FLOAT -> Kind.FLOAT;
            case ArcomatLexer.DOUBLE -> Kind.DOUBLE;
            case ArcomatLexer.CHAR -> Kind.CHAR;
            case ArcomatLexer.STRING -> Kind.STRING;
            default -> token.getText().equals("null") ? Kind.NULL : Kind.BOOLEAN;
        };
    }

    /** The text of a string literal without its quotes, of any other literal as written. */
    public static String unquoted(Token token) {
        String text = token.getText();
        return token.getType() == ArcomatLexer.STRING ? text.substring(1, text.length() - 1) : text;
    }
}
