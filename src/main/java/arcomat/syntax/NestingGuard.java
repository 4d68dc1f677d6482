package arcomat.syntax;

import arcomat.syntax.antlr.ArcomatLexer;

import org.antlr.v4.runtime.Token;

import java.util.Arrays;

/**
 * Finds nesting that would exhaust the stack, here or in a later step, before anything recursive
 * looks at the text. The bound is taken from the tokens alone: brackets that are open plus
 * operators since the last separator on each level. A parse tree is at most as deep, save for a
 * constant factor.
 */
final class NestingGuard {
    static final int LIMIT = 1000;

    private int[] outer = new int[64];
    private int open;
    private int depth;
    private int deepest;
    private int previous;
    private int beforePrevious;

    /** Takes the next token; true if it lies too deep. */
    boolean isTooDeep(Token token) {
        int type = token.getType();
        TokenKind kind = TokenKind.of(type);
        if (beginsElement(type, kind)) {
            depth = base();
        }
        switch (kind) {
            case OPENING -> enter();
            case CLOSING -> leave();
            case SEPARATOR -> depth = base();
            case OPERATOR -> depth++;
            case OTHER -> {}
        }
        beforePrevious = previous;
        previous = type;
        deepest = Math.max(deepest, depth);
        return depth > LIMIT;
    }

    /** The greatest depth of the tokens taken so far. */
    int deepest() {
        return deepest;
    }

    /** No separator stands behind a body, but what follows it is no part of an expression. */
    private boolean beginsElement(int type, TokenKind kind) {
        if (type == ArcomatLexer.LESS) {
            return previous == ArcomatLexer.LESS && beforePrevious == ArcomatLexer.CLOSE_BRACE;
        }
        return kind == TokenKind.OTHER && previous == ArcomatLexer.CLOSE_BRACE;
    }

    private int base() {
        return open == 0 ? 0 : outer[open - 1] + 1;
    }

    private void enter() {
        if (open == outer.length) {
            outer = Arrays.copyOf(outer, open * 2);
        }
        // A bracket behind a bracket may be a cast or a call: "(A) (B) (c)" is three levels deep.
        if (TokenKind.of(previous) == TokenKind.CLOSING) {
            depth++;
        }
        outer[open++] = depth;
        depth++;
    }

    private void leave() {
        if (open > 0) {
            depth = outer[--open];
        }
    }
}
