package arcomat.site;

import arcomat.syntax.antlr.ArcomatLexer;

import org.antlr.v4.runtime.CharStreams;
import org.antlr.v4.runtime.Token;

import java.util.Optional;

/** Models with colours, by the lexer that reads them. */
final class Colours {
    private Colours() {}

    static String escaped(String text) {
        return text.replace("&", "&amp;")
                .replace("<", "&lt;")
                .replace(">", "&gt;")
                .replace("\"", "&quot;");
    }

    static String html(String text) {
        ArcomatLexer lexer = new ArcomatLexer(CharStreams.fromString(text));
        lexer.removeErrorListeners();
        StringBuilder html = new StringBuilder();
        int[] points = text.codePoints().toArray();
        int done = 0;
        for (Token token : lexer.getAllTokens()) {
            html.append(escaped(new String(points, done, token.getStartIndex() - done)));
            String shown = escaped(token.getText());
            html.append(
                    kind(token)
                            .map(kind -> "<span class=\"w-" + kind + "\">" + shown + "</span>")
                            .orElse(shown));
            done = token.getStopIndex() + 1;
        }
        return html.append(escaped(new String(points, done, points.length - done))).toString();
    }

    private static Optional<String> kind(Token token) {
        return switch (token.getType()) {
            case ArcomatLexer.LINE_COMMENT, ArcomatLexer.BLOCK_COMMENT -> Optional.of("comment");
            case ArcomatLexer.STRING, ArcomatLexer.CHAR -> Optional.of("string");
            case ArcomatLexer.INT, ArcomatLexer.DOUBLE -> Optional.of("number");
            case ArcomatLexer.ID ->
                    Character.isUpperCase(token.getText().codePointAt(0))
                            ? Optional.of("type")
                            : Optional.empty();
            default ->
                    Character.isLetter(token.getText().codePointAt(0))
                            ? Optional.of("keyword")
                            : Optional.empty();
        };
    }
}
