package arcomat.syntax;

import arcomat.syntax.antlr.ArcomatLexer;

import org.antlr.v4.runtime.Token;
import org.antlr.v4.runtime.TokenStream;

import java.util.ArrayDeque;
import java.util.Deque;

/** The innermost brace that the text opens and does not close. */
final class UnclosedBrace {
    private UnclosedBrace() {}

    /** Null if every brace is closed. */
    static Token find(TokenStream tokens) {
        Deque<Token> open = new ArrayDeque<>();
        for (int i = 0; i < tokens.size(); i++) {
            Token token = tokens.get(i);
            if (token.getType() == ArcomatLexer.OPEN_BRACE) {
                open.push(token);
            } else if (token.getType() == ArcomatLexer.CLOSE_BRACE) {
                open.poll();
            }
        }
        return open.peek();
    }

    /**
     * Whether every brace has a partner, so that elements are in the bodies they were written in.
     */
    static boolean areBalanced(TokenStream tokens) {
        int depth = 0;
        for (int i = 0; i < tokens.size() && depth >= 0; i++) {
            switch (tokens.get(i).getType()) {
                case ArcomatLexer.OPEN_BRACE -> depth++;
                case ArcomatLexer.CLOSE_BRACE -> depth--;
                default -> {}
            }
        }
        return depth == 0;
    }
}
