package arcomat.syntax;

import arcomat.source.Nearest;
import arcomat.syntax.antlr.ArcomatLexer;
import arcomat.syntax.antlr.ArcomatParser;

import org.antlr.v4.runtime.BailErrorStrategy;
import org.antlr.v4.runtime.CommonToken;
import org.antlr.v4.runtime.CommonTokenStream;
import org.antlr.v4.runtime.ListTokenSource;
import org.antlr.v4.runtime.Parser;
import org.antlr.v4.runtime.ParserRuleContext;
import org.antlr.v4.runtime.RecognitionException;
import org.antlr.v4.runtime.RuleContext;
import org.antlr.v4.runtime.Token;
import org.antlr.v4.runtime.TokenStream;
import org.antlr.v4.runtime.misc.IntervalSet;
import org.antlr.v4.runtime.misc.ParseCancellationException;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.Optional;

/**
 * A word in the place of a keyword that is spelt like it. Any word may be the name of a type or of
 * a state, so that often only what follows it does not fit: a keyword is proposed for the first
 * word of an element where the text then goes on.
 *
 * @param written the word
 * @param meant the keyword
 */
record Misspelling(Token written, String meant) {

    /** Empty where no keyword is near. */
    static Optional<Misspelling> of(Parser parser, RecognitionException error) {
        Token found = error.getOffendingToken();
        IntervalSet expected = Expectation.types(error);
        // A keyword where a name may stand is one of the names, and no repair of a reserved word.
        boolean isMeant = isWord(found) && !expected.contains(ArcomatLexer.ID);
        Optional<Misspelling> here = isMeant ? near(found, keywords(expected)) : Optional.empty();
        return here.or(() -> atBeginning(parser, error));
    }

    private static Optional<Misspelling> atBeginning(Parser parser, RecognitionException error) {
        Optional<ParserRuleContext> element = element(error.getCtx());
        if (element.isEmpty() || element.get().start.getType() != ArcomatLexer.ID) {
            return Optional.empty();
        }
        int rule = element.get().getRuleIndex();
        Token first = element.get().start;
        IntervalSet beginnings = parser.getATN().nextTokens(parser.getATN().ruleToStartState[rule]);
        Map<String, Integer> keywords = keywords(beginnings);
        return near(first, keywords)
                .filter(
                        each ->
                                goesOn(
                                        parser.getInputStream(),
                                        rule,
                                        first,
                                        Objects.requireNonNull(keywords.get(each.meant())),
                                        error.getOffendingToken()));
    }

    private static Optional<ParserRuleContext> element(RuleContext context) {
        for (RuleContext each = context; each != null; each = each.parent) {
            if (each instanceof ParserRuleContext rule && Recovery.isElement(rule)) {
                return Optional.of(rule);
            }
        }
        return Optional.empty();
    }

    private static Optional<Misspelling> near(Token written, Map<String, Integer> keywords) {
        return Nearest.to(written.getText(), keywords.keySet())
                .map(meant -> new Misspelling(written, meant));
    }

    private static boolean isWord(Token token) {
        return token.getType() != Token.EOF && Character.isLetter(token.getText().charAt(0));
    }

    /** Those of the tokens that are words, by their texts. */
    private static Map<String, Integer> keywords(IntervalSet types) {
        Map<String, Integer> keywords = new HashMap<>();
        for (int type : types.toArray()) {
            String literal = type < 0 ? null : ArcomatLexer.VOCABULARY.getLiteralName(type);
            if (literal != null && Character.isLetter(literal.charAt(1))) {
                keywords.put(literal.substring(1, literal.length() - 1), type);
            }
        }
        return keywords;
    }

    /** Whether an element could be read beyond an error if it began with another word. */
    private static boolean goesOn(
            TokenStream tokens, int rule, Token first, int keyword, Token error) {
        List<Token> trial = new ArrayList<>();
        CommonToken meant = new CommonToken(first);
        meant.setType(keyword);
        trial.add(meant);
        int errorAt = 0;
        for (int i = first.getTokenIndex() + 1; i < tokens.size(); i++) {
            if (tokens.get(i) == error) {
                errorAt = trial.size();
            }
            trial.add(new CommonToken(tokens.get(i)));
        }
        ArcomatParser parser = new ArcomatParser(new CommonTokenStream(new ListTokenSource(trial)));
        parser.removeErrorListeners();
        parser.setErrorHandler(new BailErrorStrategy());
        try {
            enter(parser, rule);
        } catch (ParseCancellationException stopped) {
            return parser.getInputStream().index() > errorAt;
        }
        return true;
    }

    private static void enter(ArcomatParser parser, int rule) {
        switch (rule) {
            case ArcomatParser.RULE_element -> parser.element();
            case ArcomatParser.RULE_automatonElement -> parser.automatonElement();
            case ArcomatParser.RULE_typeDefinition -> parser.typeDefinition();
            case ArcomatParser.RULE_suiteMember -> parser.suiteMember();
            case ArcomatParser.RULE_testPart -> parser.testPart();
            default -> throw new ParseCancellationException();
        }
    }
}
