package arcomat.syntax.runtime;

import arcomat.source.SourceFile;

import org.antlr.v4.runtime.CharStream;
import org.antlr.v4.runtime.CommonTokenStream;
import org.antlr.v4.runtime.Lexer;
import org.antlr.v4.runtime.Token;

import java.util.function.Function;

/**
 * All tokens of a text. The parser asks for the next and the previous token several times per rule;
 * ANTLR's own stream looks each time whether there are more tokens to be fetched.
 */
public final class FilledTokens extends CommonTokenStream {
    private FilledTokens(SourceFile file, Lexer lexer) {
        super(lexer);
        tokens = new Scan(file, lexer).tokens();
        fetchedEOF = true;
        p = visible(0);
    }

    /**
     * @param lexer makes the lexer of the file's language
     */
    public static FilledTokens of(SourceFile file, Function<CharStream, Lexer> lexer) {
        Lexer rules = lexer.apply(new Characters(file.path(), file.text()));
        rules.removeErrorListeners();
        return new FilledTokens(file, rules);
    }

    /** The index of the first token from one on that the parser sees. */
    private int visible(int from) {
        int index = from;
        while (tokens.get(index).getChannel() != channel) {
            index++;
        }
        return index;
    }

    @Override
    public int LA(int offset) {
        return offset == 1 ? tokens.get(p).getType() : super.LA(offset);
    }

    @Override
    public Token LT(int offset) {
        if (offset == 1) {
            return tokens.get(p);
        }
        return offset == -1 && p > 0 && tokens.get(p - 1).getChannel() == channel
                ? tokens.get(p - 1)
                : super.LT(offset);
    }

    @Override
    public void consume() {
        if (p == tokens.size() - 1) {
            throw new IllegalStateException("consume at the end of the text");
        }
        p = visible(p + 1);
    }

    @Override
    public void seek(int index) {
        p = visible(index);
    }
}
