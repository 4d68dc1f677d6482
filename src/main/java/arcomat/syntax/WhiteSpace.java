package arcomat.syntax;

import arcomat.source.SourceFile;

import org.antlr.v4.runtime.Token;

import java.util.HashSet;
import java.util.List;
import java.util.Set;
import java.util.stream.IntStream;

/** What stands between tokens and comments. */
public final class WhiteSpace {
    private WhiteSpace() {}

    /** Whether two texts have the same tokens and comments. */
    public static boolean isAllThatDiffers(SourceFile one, SourceFile other) {
        return tokens(one).equals(tokens(other));
    }

    private static List<String> tokens(SourceFile file) {
        return Reading.tokens(file).getTokens().stream()
                .map(Token::getText)
                .filter(text -> !text.isBlank())
                .toList();
    }

    /** The lines that begin in the middle of a comment, and are a part of it; the first is 0. */
    public static Set<Integer> linesWithinComments(SourceFile file) {
        Set<Integer> within = new HashSet<>();
        for (Token token : Reading.tokens(file).getTokens()) {
            if (!token.getText().isBlank()) {
                int first =
                        file.span(token.getStartIndex(), token.getStartIndex())
                                        .startPosition()
                                        .line()
                                - 1;
                int more = (int) token.getText().chars().filter(sign -> sign == '\n').count();
                IntStream.rangeClosed(1, more).forEach(line -> within.add(first + line));
            }
        }
        return within;
    }
}
