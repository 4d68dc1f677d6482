package arcomat.syntax.runtime;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import arcomat.source.SourceFile;
import arcomat.syntax.antlr.ArcomatLexer;

import org.antlr.v4.runtime.CharStreams;
import org.antlr.v4.runtime.CommonTokenStream;
import org.antlr.v4.runtime.Token;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** The stream shows the parser what ANTLR's own one shows, comments anywhere. */
class FilledTokensTest {

    @ParameterizedTest
    @ValueSource(
            strings = {
                "",
                "a",
                "/* only */",
                "/* first */ a // last",
                "a /* one */ /* two */ b c /* three */"
            })
    void showsWhatAntlrShows(String text) {
        CommonTokenStream expected = new CommonTokenStream(lexer(text));
        FilledTokens tokens = FilledTokens.of(new SourceFile("a.arc", text), ArcomatLexer::new);
        expected.fill();
        while (true) {
            for (int offset = -2; offset <= 3; offset++) {
                assertThat(words(tokens.LT(offset))).isEqualTo(words(expected.LT(offset)));
            }
            assertThat(tokens.index()).isEqualTo(expected.index());
            if (expected.LA(1) == Token.EOF) {
                break;
            }
            tokens.consume();
            expected.consume();
        }
        assertThatThrownBy(tokens::consume).isInstanceOf(IllegalStateException.class);
        tokens.seek(0);
        expected.seek(0);
        assertThat(tokens.index()).isEqualTo(expected.index());
    }

    private static String words(Token token) {
        return token == null ? "none" : token.getText() + " at " + token.getStartIndex();
    }

    private static ArcomatLexer lexer(String text) {
        return new ArcomatLexer(CharStreams.fromString(text));
    }
}
