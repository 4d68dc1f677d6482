package arcomat.syntax;

import arcomat.syntax.antlr.ArcomatLexer;

import org.antlr.v4.runtime.Token;
import org.antlr.v4.runtime.TokenStream;

/** Where an element with an error ends, judged by semicolons and braces. */
final class ElementEnd {
    private ElementEnd() {}

    /**
     * @param start index of the element's first token
     * @param error index of the first token that does not fit
     * @param hasBody whether semicolons may stand in its braces, line by line. If not, a semicolon
     *     at the end of a line ends it, even if a brace is missing.
     * @param isStatement whether the brace that closes the body around it may be followed by the
     *     rest of an element, as that of {@code do {..};}
     * @return index of the first token behind the element, greater than {@code start} unless that
     *     token closes the body around it
     */
    static int find(
            TokenStream tokens, int start, int error, boolean hasBody, boolean isStatement) {
        int depth = 0;
        for (int i = start; ; i++) {
            Token token = tokens.get(i);
            boolean reached = i >= error;
            switch (token.getType()) {
                case Token.EOF -> {
                    return i;
                }
                case ArcomatLexer.OPEN_BRACE -> depth++;
                case ArcomatLexer.CLOSE_BRACE -> {
                    if (depth == 0 && reached && (isStatement || !goesOn(tokens, i))) {
                        return i;
                    }
                    depth = Math.max(0, depth - 1);
                    if (depth == 0 && reached && !goesOn(tokens, i)) {
                        return i + 1;
                    }
                }
                case ArcomatLexer.SEMICOLON -> {
                    if (reached && (depth == 0 || !hasBody && isLastOfLine(tokens, i))) {
                        return i + 1;
                    }
                }
                default -> {}
            }
        }
    }

    /** Whether an element goes on behind a brace: {@code A -> B {x} / {y};}. */
    private static boolean goesOn(TokenStream tokens, int brace) {
        int next = next(tokens, brace).getType();
        TokenKind kind = TokenKind.of(next);
        return kind == TokenKind.SEPARATOR
                || kind == TokenKind.OPENING
                || kind.isOperator() && next != ArcomatLexer.LESS;
    }

    private static boolean isLastOfLine(TokenStream tokens, int index) {
        return next(tokens, index).getLine() > tokens.get(index).getLine();
    }

    private static Token next(TokenStream tokens, int index) {
        int next = index + 1;
        while (tokens.get(next).getChannel() != Token.DEFAULT_CHANNEL) {
            next++;
        }
        return tokens.get(next);
    }
}
