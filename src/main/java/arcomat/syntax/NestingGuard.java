package arcomat.syntax;

import arcomat.syntax.antlr.ArcomatLexer;

import org.antlr.v4.runtime.Token;

import java.util.Arrays;

/**
 * Finds nesting that would exhaust the stack, here or in a later step, before anything recursive
 * looks at the text. The bound is taken from the tokens alone: brackets that are open plus
 * operators since the last separator on each level, without those of operands of {@code &&} and
 * {@code ||} that are complete: rows of these are built as shallow trees. A parse tree is at most
 * as deep, save for a constant factor, and for rows of these two, which nobody descends into.
 */
final class NestingGuard {
    static final int LIMIT = 1000;

    /** Fits a stack of a megabyte, of which a browser's frames take more than Java's. */
    static final int LIMIT_OF_SMALL_STACK = 300;

    private final int limit;
    private int[] outer = new int[64];
    private int[] tightOutside = new int[64];
    private int open;
    private int depth;

    /** Operators since the last one that does not bind tighter than a row. */
    private int tight;

    private int deepest;
    private int previous;
    private int beforePrevious;

    /**
     * @param limit so many levels are not too deep
     */
    NestingGuard(int limit) {
        this.limit = limit;
    }

    /** Takes the next token; true if it lies too deep. */
    boolean isTooDeep(Token token) {
        int type = token.getType();
        TokenKind kind = TokenKind.of(type);
        if (beginsElement(type, kind)) {
            depth = base();
            tight = 0;
        }
        switch (kind) {
            case OPENING -> enter();
            case CLOSING -> leave();
            case SEPARATOR -> {
                depth = base();
                tight = 0;
            }
            case OPERATOR -> {
                depth++;
                tight++;
            }
            case CHAIN -> {
                depth -= tight;
                tight = 0;
            }
            case LOOSE -> {
                depth++;
                tight = 0;
            }
            case OTHER -> {}
        }
        beforePrevious = previous;
        previous = type;
        deepest = Math.max(deepest, depth);
        return depth > limit;
    }

    /** So many levels are not too deep. */
    int limit() {
        return limit;
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
            tightOutside = Arrays.copyOf(tightOutside, open * 2);
        }
        // A bracket behind a bracket may be a cast or a call: "(A) (B) (c)" is three levels deep.
        if (TokenKind.of(previous) == TokenKind.CLOSING) {
            depth++;
            tight++;
        }
        tightOutside[open] = tight;
        outer[open++] = depth;
        depth++;
        tight = 0;
    }

    private void leave() {
        if (open > 0) {
            depth = outer[--open];
            tight = tightOutside[open];
        }
    }
}
