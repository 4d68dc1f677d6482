package arcomat.syntax.runtime;

import static org.assertj.core.api.Assertions.assertThat;

import arcomat.source.SourceFile;
import arcomat.syntax.antlr.ArcomatLexer;

import net.jqwik.api.ForAll;
import net.jqwik.api.Property;

import org.antlr.v4.runtime.CommonTokenStream;
import org.antlr.v4.runtime.Token;

import java.util.List;
import java.util.Random;

/** The way through the lexer's table gives the tokens that the lexer gives, whatever the text. */
class ScanTest {
    private static final List<String> PIECES =
            List.of(
                    "component",
                    "a",
                    "0..5",
                    "1.5e3",
                    "0x1F",
                    "7L",
                    "\"a\\n\"",
                    "\"open",
                    "'c'",
                    "/* c */",
                    "/* * / **/",
                    "/* open",
                    "// line\n",
                    "\r\n",
                    "\r",
                    "\t",
                    " ",
                    "--",
                    "->",
                    "<=>",
                    "<<",
                    "==",
                    "=",
                    "&",
                    "\u00e9t\u00e9",
                    "\u00d7",
                    "\ud83d\ude00",
                    "#",
                    ".",
                    "_$1",
                    "&&",
                    "|",
                    "{",
                    "}");

    /** Texts of pieces in any order, joined without spaces as well. */
    @Property(seed = "1", tries = 500)
    void tokensAreTheLexers(@ForAll long seed) {
        Random random = new Random(seed);
        StringBuilder text = new StringBuilder();
        for (int i = random.nextInt(40); i >= 0; i--) {
            text.append(PIECES.get(random.nextInt(PIECES.size())));
        }
        check(text.toString());
    }

    private static void check(String text) {
        SourceFile file = new SourceFile("a.arc", text);
        CommonTokenStream expected = new CommonTokenStream(lexer(text));
        expected.fill();
        List<Token> tokens = FilledTokens.of(file, ArcomatLexer::new).getTokens();
        assertThat(tokens.stream().map(ScanTest::words).toList())
                .isEqualTo(expected.getTokens().stream().map(ScanTest::words).toList());
    }

    private static String words(Token token) {
        return "%d %s: %s, %d to %d on %d"
                .formatted(
                        token.getTokenIndex(),
                        ArcomatLexer.VOCABULARY.getDisplayName(token.getType()),
                        token.getText(),
                        token.getStartIndex(),
                        token.getStopIndex(),
                        token.getChannel());
    }

    private static ArcomatLexer lexer(String text) {
        ArcomatLexer lexer = new ArcomatLexer(new Characters("a.arc", text));
        lexer.removeErrorListeners();
        return lexer;
    }
}
