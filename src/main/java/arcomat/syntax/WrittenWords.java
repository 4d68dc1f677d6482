package arcomat.syntax;

import arcomat.source.Span;

import org.antlr.v4.runtime.Token;

import java.util.List;

/** The words in a text: what could be a name or a keyword, without comments and strings. */
public final class WrittenWords {
    private WrittenWords() {}

    /** Those in a part of a file, in the order of the text. */
    public static List<Span> in(Span part) {
        return Reading.tokens(part.file()).getTokens().stream()
                .filter(WrittenWords::isWord)
                .map(each -> part.file().span(each.getStartIndex(), each.getStopIndex() + 1))
                .filter(part::isAround)
                .toList();
    }

    private static boolean isWord(Token token) {
        return token.getType() != Token.EOF
                && token.getChannel() == Token.DEFAULT_CHANNEL
                && Character.isJavaIdentifierStart(token.getText().charAt(0));
    }
}
