package arcomat.syntax.runtime;

import arcomat.source.Position;
import arcomat.source.SourceFile;

import org.antlr.v4.runtime.CharStream;
import org.antlr.v4.runtime.Lexer;
import org.antlr.v4.runtime.Token;
import org.antlr.v4.runtime.atn.ATNSimulator;
import org.antlr.v4.runtime.atn.LexerATNSimulator;
import org.antlr.v4.runtime.dfa.DFA;
import org.antlr.v4.runtime.dfa.DFAState;
import org.jspecify.annotations.Nullable;

import java.util.ArrayList;
import java.util.List;

/**
 * All tokens of a text, as the generated lexer would give them one by one. That lexer keeps a table
 * of what it has found out, shared by all of its kind; as long as the table knows the way, the text
 * is read straight through it. Where it does not, and for letters beyond ASCII, which it never
 * holds, the lexer is asked, and what it finds out is in the table then.
 */
final class Scan {
    /** A guess of how many characters there are for each token, spaces and comments included. */
    private static final int CHARACTERS_PER_TOKEN = 3;

    private final SourceFile file;
    private final String letters;
    private final CharStream text;
    private final Lexer lexer;
    private final DFA table;

    /** Behind the token that was matched last. */
    private int place;

    /**
     * @param lexer of rules without modes and {@code more}, one of which takes whatever the others
     *     do not; its table ends where a rule has a predicate
     */
    Scan(SourceFile file, Lexer lexer) {
        this.file = file;
        this.letters = file.text();
        this.text = lexer.getInputStream();
        this.lexer = lexer;
        this.table = lexer.getInterpreter().getDFA(Lexer.DEFAULT_MODE);
    }

    CharStream text() {
        return text;
    }

    Lexer lexer() {
        return lexer;
    }

    Position position(int offset) {
        return file.position(offset);
    }

    /** The end of the file included. */
    List<Token> tokens() {
        int length = letters.length();
        List<Token> tokens = new ArrayList<>(length / CHARACTERS_PER_TOKEN + 8);
        while (place < length) {
            int start = place;
            int type = match();
            if (type != Lexer.SKIP) {
                boolean isHidden = lexer._channel != Token.DEFAULT_CHANNEL;
                tokens.add(new Lexeme(this, type, start, place, tokens.size(), isHidden));
            }
        }
        tokens.add(new Lexeme(this, Token.EOF, length, length, tokens.size(), false));
        return tokens;
    }

    /** The type of the token at the place; its channel is the lexer's then. */
    private int match() {
        lexer._channel = Token.DEFAULT_CHANNEL;
        lexer._type = Token.INVALID_TYPE;
        int start = place;
        DFAState accepting = longest();
        if (accepting == null) {
            text.seek(start);
            int type = lexer.getInterpreter().match(text, Lexer.DEFAULT_MODE);
            place = text.index();
            return changed(type);
        }
        if (accepting.lexerActionExecutor != null) {
            accepting.lexerActionExecutor.execute(lexer, text, start);
        }
        return changed(accepting.prediction);
    }

    /** Actions of a rule may have set another type, as {@code skip} does. */
    private int changed(int type) {
        return lexer._type == Token.INVALID_TYPE ? type : lexer._type;
    }

    /** Where the table ends behind the longest token; null if it does not know. */
    private @Nullable DFAState longest() {
        DFAState accepting = null;
        DFAState state = table.s0;
        for (int i = place; i < letters.length(); i++) {
            state = next(state, letters.charAt(i));
            if (state == null) {
                return null;
            }
            if (state == ATNSimulator.ERROR) {
                break;
            }
            if (state.isAcceptState) {
                accepting = state;
                place = i + 1;
            }
        }
        return accepting;
    }

    private static @Nullable DFAState next(@Nullable DFAState state, char letter) {
        return state == null || state.edges == null || letter > LexerATNSimulator.MAX_DFA_EDGE
                ? null
                : state.edges[letter];
    }
}
