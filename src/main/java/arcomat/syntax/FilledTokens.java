package arcomat.syntax;

import org.antlr.v4.runtime.CommonTokenStream;
import org.antlr.v4.runtime.Token;
import org.antlr.v4.runtime.TokenSource;

/**
 * All tokens of a text, with the way past comments computed once. The parser asks for the next and
 * the previous token several times per rule; ANTLR's own stream looks for them each time.
 */
final class FilledTokens extends CommonTokenStream {
    private final Token[] before;
    private final int[] behind;

    FilledTokens(TokenSource source) {
        super(source);
        fill();
        before = new Token[tokens.size()];
        behind = new int[tokens.size()];
        Token visible = null;
        int last = 0;
        for (int i = 0; i < behind.length; i++) {
            before[i] = visible;
            if (tokens.get(i).getChannel() == channel) {
                visible = tokens.get(i);
                behind[last] = i;
                last = i;
            }
        }
        behind[last] = last;
    }

    @Override
    public Token LT(int offset) {
        if (offset == 1) {
            return tokens.get(p);
        }
        return offset == -1 ? before[p] : super.LT(offset);
    }

    @Override
    public void consume() {
        if (behind[p] == p) {
            throw new IllegalStateException("consume at the end of the text");
        }
        p = behind[p];
    }
}
