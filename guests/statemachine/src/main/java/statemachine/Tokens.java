package statemachine;

import java.util.ArrayList;
import java.util.List;
import java.util.regex.Matcher;
import java.util.regex.Pattern;

/** Takes a text apart; comments and space are left out. */
final class Tokens {
    private static final Pattern NEXT =
            Pattern.compile(
                    "(?<skip>\\s+|//[^\\r"
                        + "\\n"
                        + "]*|/\\*(?s:.*?)\\*/)|(?<word>[\\p{L}_$][\\p{L}\\p{N}_$]*)"
                        + "|(?<literal>\\p{N}[\\p{L}\\p{N}_]*|\"(?:\\\\.|[^\"\\\\])*\"|'(?:\\\\.|[^'\\\\])*')"
                        + "|(?<sign>->|<=>|==|!=|<=|>=|--|(?s:.))");

    private Tokens() {}

    /** With an end behind the last. */
    static List<Token> of(String text) {
        List<Token> tokens = new ArrayList<>();
        Matcher next = NEXT.matcher(text);
        while (next.find()) {
            if (next.group("skip") == null) {
                tokens.add(new Token(kind(next), next.group(), next.start()));
            }
        }
        tokens.add(new Token(Token.Kind.END, "", text.length()));
        return tokens;
    }

    private static Token.Kind kind(Matcher next) {
        if (next.group("word") != null) {
            return Token.Kind.WORD;
        }
        return next.group("literal") != null ? Token.Kind.LITERAL : Token.Kind.SIGN;
    }
}
