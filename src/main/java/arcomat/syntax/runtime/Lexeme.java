package arcomat.syntax.runtime;

import org.antlr.v4.runtime.CharStream;
import org.antlr.v4.runtime.Token;
import org.antlr.v4.runtime.TokenSource;
import org.antlr.v4.runtime.misc.Interval;

/**
 * A token that knows where it stands, and finds out the rest where somebody asks: the lines of most
 * tokens and the texts of many are never looked at.
 */
final class Lexeme implements Token {
    private final Scan source;
    private final int type;
    private final int start;
    private final int end;
    private final int index;
    private final boolean isHidden;

    /**
     * @param end the place behind it
     * @param index its number among the tokens of the text, from 0
     * @param isHidden whether the parser does not see it
     */
    Lexeme(Scan source, int type, int start, int end, int index, boolean isHidden) {
        this.source = source;
        this.type = type;
        this.start = start;
        this.end = end;
        this.index = index;
        this.isHidden = isHidden;
    }

    @Override
    public String getText() {
        return type == EOF ? "<EOF>" : getInputStream().getText(Interval.of(start, end - 1));
    }

    @Override
    public int getType() {
        return type;
    }

    @Override
    public int getLine() {
        return source.position(start).line();
    }

    @Override
    public int getCharPositionInLine() {
        return source.position(start).column() - 1;
    }

    @Override
    public int getChannel() {
        return isHidden ? HIDDEN_CHANNEL : DEFAULT_CHANNEL;
    }

    @Override
    public int getTokenIndex() {
        return index;
    }

    @Override
    public int getStartIndex() {
        return start;
    }

    @Override
    public int getStopIndex() {
        return end - 1;
    }

    @Override
    public TokenSource getTokenSource() {
        return source.lexer();
    }

    @Override
    public CharStream getInputStream() {
        return source.text();
    }

    /** As ANTLR shows its own tokens where a parser is debugged. */
    @Override
    public String toString() {
        return "[@%d,%d:%d='%s',<%d>]".formatted(index, start, getStopIndex(), getText(), type);
    }
}
