package arcomat.syntax;

import arcomat.source.Diagnostic;
import arcomat.source.SourceFile;
import arcomat.syntax.antlr.ArcomatLexer;

import org.antlr.v4.runtime.Token;

import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Set;

/**
 * Finds invariants that nothing ends. Their text may be of any language, so that a parser takes
 * what stands behind one for a part of it, up to the next semicolon, and says that what was
 * declared there is missing.
 */
final class InvariantEnd {
    private static final int INVARIANT = types("inv").iterator().next();

    /** What elements of a component begin with, unless it is a type. */
    private static final Set<Integer> BEGINNINGS =
            types(
                    "autoconnect",
                    "autoinstantiate",
                    "automaton",
                    "behavior",
                    "component",
                    "compute",
                    "connect",
                    "constraint",
                    "feature",
                    "implementation",
                    "inv",
                    "port",
                    "ports",
                    "timing",
                    "var",
                    "varif");

    private final SourceFile file;
    private final List<Token> tokens;

    private InvariantEnd(SourceFile file, List<Token> tokens) {
        this.file = file;
        this.tokens = tokens;
    }

    private static Set<Integer> types(String... words) {
        Set<String> wanted = Set.of(words);
        Set<Integer> types = new HashSet<>();
        for (int type = 0; type <= ArcomatLexer.VOCABULARY.getMaxTokenType(); type++) {
            String literal = ArcomatLexer.VOCABULARY.getLiteralName(type);
            if (literal != null && wanted.contains(literal.substring(1, literal.length() - 1))) {
                types.add(type);
            }
        }
        return types;
    }

    /** Whether an invariant may begin there: most files have none, and need not be looked at. */
    static boolean begins(Token token) {
        return token.getType() == INVARIANT;
    }

    /**
     * The semicolons that are missing.
     *
     * @param all tokens of the file, the end of the file included
     */
    static List<Diagnostic> missing(SourceFile file, List<Token> all) {
        List<Token> visible =
                all.stream().filter(each -> each.getChannel() == Token.DEFAULT_CHANNEL).toList();
        return new InvariantEnd(file, visible).missing();
    }

    private List<Diagnostic> missing() {
        List<Diagnostic> findings = new ArrayList<>();
        for (int i = 0; i + 3 < tokens.size(); i++) {
            if (type(i) == INVARIANT && tokens.get(i + 2).getText().equals(":")) {
                int end = end(i + 3);
                if (type(end) != ArcomatLexer.SEMICOLON && type(end) != Token.EOF) {
                    findings.add(SyntaxErrorMessage.semicolonMissing(file, tokens.get(end - 1)));
                }
            }
        }
        return findings;
    }

    /** The semicolon behind a text, or what cannot be a part of it; Java in braces ends itself. */
    private int end(int start) {
        int i = start;
        boolean isJava = type(start) == ArcomatLexer.OPEN_BRACE;
        while (type(i) != Token.EOF
                && type(i) != ArcomatLexer.SEMICOLON
                && (isJava || i == start || !isElement(i))) {
            i++;
        }
        return i;
    }

    /** At the beginning of a line, behind what needs no more, and before what is no operator. */
    private boolean isElement(int i) {
        TokenKind before = TokenKind.of(type(i - 1));
        TokenKind after = TokenKind.of(type(i + 1));
        boolean isStereotype = type(i) == ArcomatLexer.LESS && type(i + 1) == ArcomatLexer.LESS;
        boolean isWord =
                (BEGINNINGS.contains(type(i)) || type(i + 1) == INVARIANT)
                        && (after == TokenKind.OTHER || type(i + 1) == ArcomatLexer.OPEN_BRACE);
        return (isStereotype || isWord)
                && (before == TokenKind.OTHER || before == TokenKind.CLOSING)
                && tokens.get(i - 1).getLine() < tokens.get(i).getLine();
    }

    private int type(int index) {
        return tokens.get(index).getType();
    }
}
