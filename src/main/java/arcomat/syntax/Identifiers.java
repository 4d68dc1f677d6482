package arcomat.syntax;

import arcomat.syntax.antlr.ArcomatLexer;
import arcomat.syntax.antlr.ArcomatParser;

import org.antlr.v4.runtime.BailErrorStrategy;
import org.antlr.v4.runtime.CharStreams;
import org.antlr.v4.runtime.CommonTokenStream;
import org.antlr.v4.runtime.Token;
import org.antlr.v4.runtime.misc.ParseCancellationException;

import java.util.Optional;

/** What may be a name. Most keywords may: the words of expressions and of Java's types may not. */
public final class Identifiers {
    private Identifiers() {}

    /** Why a text is no name, as a sentence; empty where it is one. */
    public static Optional<String> problem(String text) {
        ArcomatLexer lexer = new ArcomatLexer(CharStreams.fromString(text));
        lexer.removeErrorListeners();
        CommonTokenStream tokens = new CommonTokenStream(lexer);
        tokens.fill();
        Token first = tokens.get(0);
        boolean isOneWord =
                tokens.size() == 2
                        && first.getText().length() == text.length()
                        && Character.isJavaIdentifierStart(text.charAt(0));
        if (!isOneWord) {
            return Optional.of(
                    ("'%s' is no name; names are made of letters, digits, '_' and '$', and do not"
                                    + " begin with a digit")
                            .formatted(text));
        }
        return isName(tokens)
                ? Optional.empty()
                : Optional.of(
                        "'%s' is a word of the language; choose another name".formatted(text));
    }

    /** Whether a text is a name that the language has no use for as a word. */
    public static boolean isFree(String text) {
        ArcomatLexer lexer = new ArcomatLexer(CharStreams.fromString(text));
        lexer.removeErrorListeners();
        Token only = lexer.nextToken();
        return only.getType() == ArcomatLexer.ID && only.getText().equals(text);
    }

    private static boolean isName(CommonTokenStream tokens) {
        ArcomatParser parser = new ArcomatParser(tokens);
        parser.removeErrorListeners();
        parser.setErrorHandler(new BailErrorStrategy());
        try {
            parser.name();
            return true;
        } catch (ParseCancellationException reserved) {
            return false;
        }
    }
}
