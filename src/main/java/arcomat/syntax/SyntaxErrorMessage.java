package arcomat.syntax;

import arcomat.source.Diagnostic;
import arcomat.source.Fix;
import arcomat.source.SourceFile;
import arcomat.source.Span;
import arcomat.syntax.antlr.ArcomatLexer;
import arcomat.syntax.antlr.ArcomatParser;

import org.antlr.v4.runtime.Parser;
import org.antlr.v4.runtime.ParserRuleContext;
import org.antlr.v4.runtime.RecognitionException;
import org.antlr.v4.runtime.Token;
import org.antlr.v4.runtime.TokenStream;
import org.antlr.v4.runtime.misc.IntervalSet;
import org.jspecify.annotations.Nullable;

import java.util.List;
import java.util.Objects;
import java.util.Set;

/** From an error of ANTLR's to a finding in the user's terms. */
final class SyntaxErrorMessage {
    private static final int LONGEST_QUOTE = 30;
    private static final Set<String> DEFINITIONS =
            Set.of("component", "abstract", "deploy", "automaton", "classdiagram", "testsuite");

    private final SourceFile file;
    private final Parser parser;
    private final RecognitionException error;
    private final Token found;
    private final IntervalSet expected;

    SyntaxErrorMessage(SourceFile file, Parser parser, RecognitionException error) {
        this.file = file;
        this.parser = parser;
        this.error = error;
        this.found = error.getOffendingToken();
        this.expected = Expectation.types(error);
    }

    Diagnostic finding() {
        if (isDefinitionMissing()) {
            return Language.of(file).nothingDefined(file, found.getStartIndex());
        }
        if (found.getType() == ArcomatLexer.UNKNOWN && !isHalfOperator()) {
            return UnknownCharacter.finding(span(found));
        }
        if (isSemicolonMissing(parser, error)) {
            Token before = Objects.requireNonNull(before(parser.getInputStream(), found));
            return semicolonMissing(file, before);
        }
        if (found.getType() == Token.EOF) {
            return endOfFile();
        }
        return Misspelling.of(parser, error)
                .map(this::misspelt)
                .orElseGet(() -> Diagnostic.error(Codes.SYNTAX, span(found), message()));
    }

    private Diagnostic misspelt(Misspelling misspelling) {
        Span word = span(misspelling.written());
        String meant = misspelling.meant();
        return Diagnostic.error(
                        Codes.SYNTAX,
                        word,
                        "Unexpected %s. Did you mean '%s'?".formatted(quote(word), meant))
                .withFix(
                        Fix.replace("Replace " + quote(word) + " by '" + meant + "'", word, meant));
    }

    private boolean isDefinitionMissing() {
        return found.getType() == Token.EOF
                && error.getCtx() instanceof ParserRuleContext context
                && (context.getParent() == null || context.start.getType() == Token.EOF)
                && !expected.contains(Token.EOF);
    }

    /** The next line begins where only a semicolon is missed. */
    static boolean isSemicolonMissing(Parser parser, RecognitionException error) {
        Token found = error.getOffendingToken();
        Token before = before(parser.getInputStream(), found);
        return before != null
                && error.getCtx() instanceof ParserRuleContext context
                && before.getTokenIndex() >= context.start.getTokenIndex()
                && before.getLine() < found.getLine()
                && before.getType() != ArcomatLexer.SEMICOLON
                && Expectation.types(error).contains(ArcomatLexer.SEMICOLON);
    }

    /** The finding that a token is the last one of what needs a semicolon. */
    static Diagnostic semicolonMissing(SourceFile file, Token last) {
        Span before = file.span(last.getStartIndex(), last.getStopIndex() + 1);
        Span end = file.span(before.end(), before.end());
        return Diagnostic.error(
                        Codes.SYNTAX, before, "';' is missing behind " + quote(before) + ".")
                .withFix(Fix.replace("Insert ';'", end, ";"));
    }

    private Diagnostic endOfFile() {
        Token last = before(parser.getInputStream(), found);
        Diagnostic finding =
                Diagnostic.error(
                        Codes.SYNTAX,
                        last == null ? span(found) : span(last),
                        "The file ends too early." + expectationSentence());
        Token brace = UnclosedBrace.find(parser.getInputStream());
        return brace == null
                ? finding
                : finding.withRelated(span(brace), "this brace is not closed");
    }

    private String message() {
        String quoted = quote(span(found));
        if (isHalfOperator()) {
            return "%s has no meaning here. Write '%s' for \"%s\"."
                    .formatted(
                            quoted,
                            found.getText().repeat(2),
                            found.getText().equals("&") ? "and" : "or");
        }
        if (found.getText().equals("#")) {
            return UnknownCharacter.finding(span(found)).message();
        }
        if (found.getText().equals("=") && isInCondition()) {
            return "'=' does not compare. Write '==' for \"is equal to\".";
        }
        if (found.getText().equals("if") && isInAutomaton()) {
            return "'if' begins no transition. Write its condition in brackets behind its states:"
                    + " 'from -> to [condition] / {port = value};'.";
        }
        if (isReservedWord() && expected.contains(ArcomatLexer.ID)) {
            return quoted + " is a reserved word and cannot be a name. Choose another name.";
        }
        if (expected.size() == 1 && expected.contains(Token.EOF) && isDefinition()) {
            return "A file has one definition, and this is another one. Move it to a file of its"
                    + " own, or look for a '}' too many above.";
        }
        if (expected.size() == 1 && expected.contains(Token.EOF)) {
            return quoted
                    + " stands behind the end of the definition. Remove it, or look for a '}'"
                    + " too many above.";
        }
        return "Unexpected " + quoted + "." + expectationSentence();
    }

    private boolean isHalfOperator() {
        return found.getText().equals("&") || found.getText().equals("|") && isInCondition();
    }

    private boolean isInCondition() {
        for (var c = error.getCtx(); c != null; c = c.parent) {
            if (c.getRuleIndex() == ArcomatParser.RULE_guard) {
                return true;
            }
        }
        return false;
    }

    private boolean isInAutomaton() {
        return error.getCtx() != null
                && (error.getCtx().getRuleIndex() == ArcomatParser.RULE_automaton
                        || error.getCtx().getRuleIndex() == ArcomatParser.RULE_automatonElement);
    }

    /** Whether a definition of the file's language begins here. */
    private boolean isDefinition() {
        return DEFINITIONS.contains(found.getText());
    }

    private boolean isReservedWord() {
        return Character.isLetter(found.getText().charAt(0))
                && found.getType() != ArcomatLexer.ID
                && !parser.getATN()
                        .nextTokens(parser.getATN().ruleToStartState[ArcomatParser.RULE_name])
                        .contains(found.getType());
    }

    private String expectationSentence() {
        List<String> words = Expectation.words(parser, error);
        if (words.isEmpty()) {
            return "";
        }
        int last = words.size() - 1;
        String list =
                last == 0
                        ? words.get(0)
                        : String.join(", ", words.subList(0, last)) + " or " + words.get(last);
        return " Expected " + list + ".";
    }

    /** The last token of the languages before another, null before the first. */
    static @Nullable Token before(TokenStream tokens, Token token) {
        for (int i = token.getTokenIndex() - 1; i >= 0; i--) {
            if (tokens.get(i).getChannel() == Token.DEFAULT_CHANNEL) {
                return tokens.get(i);
            }
        }
        return null;
    }

    private Span span(Token token) {
        if (token.getType() == Token.EOF) {
            return file.span(file.text().length(), file.text().length());
        }
        return file.span(token.getStartIndex(), token.getStopIndex() + 1);
    }

    private static String quote(Span span) {
        String text = span.text();
        if (text.length() <= LONGEST_QUOTE) {
            return "'" + text + "'";
        }
        boolean isSplit = Character.isHighSurrogate(text.charAt(LONGEST_QUOTE - 1));
        return "'" + text.substring(0, LONGEST_QUOTE - (isSplit ? 1 : 0)) + "…'";
    }
}
