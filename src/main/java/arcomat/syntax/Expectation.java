package arcomat.syntax;

import arcomat.syntax.antlr.ArcomatLexer;
import arcomat.syntax.antlr.ArcomatParser;

import org.antlr.v4.runtime.NoViableAltException;
import org.antlr.v4.runtime.Parser;
import org.antlr.v4.runtime.ParserRuleContext;
import org.antlr.v4.runtime.RecognitionException;
import org.antlr.v4.runtime.Token;
import org.antlr.v4.runtime.TokenStream;
import org.antlr.v4.runtime.atn.ATN;
import org.antlr.v4.runtime.atn.ATNConfig;
import org.antlr.v4.runtime.atn.Transition;
import org.antlr.v4.runtime.misc.IntervalSet;
import org.jspecify.annotations.Nullable;

import java.util.ArrayList;
import java.util.List;
import java.util.Set;

/** What could have stood in place of an offending token, in words. */
final class Expectation {
    private static final int MOST_WORDS = 6;

    /** Named before other tokens, because one of them is what most often was forgotten. */
    private static final String[] TELLING = {"';'", "','", "')'", "']'", "'}'", "'->'"};

    private static final Set<String> CONTINUATIONS = Set.of("'.'", "'<'", "'['", "'('");

    private final ATN atn;
    private final IntervalSet types;
    private final List<String> words = new ArrayList<>();

    private Expectation(ATN atn, IntervalSet types) {
        this.atn = atn;
        this.types = types;
    }

    /** The token types that the parser could have gone on with. */
    static IntervalSet types(RecognitionException error) {
        if (error instanceof NoViableAltException prediction
                && prediction.getDeadEndConfigs() != null) {
            return typesBehind(prediction);
        }
        IntervalSet expected = error.getExpectedTokens();
        IntervalSet types = expected == null ? new IntervalSet() : new IntervalSet(expected);
        types.addAll(headerWords(error, types));
        return types;
    }

    /**
     * Where a definition is to begin, the file may begin as well, or import more: that is decided
     * before the definition is looked at, and unknown to it.
     */
    private static IntervalSet headerWords(RecognitionException error, IntervalSet others) {
        IntervalSet words = new IntervalSet();
        if (error.getCtx() == null
                || error.getCtx().parent != null
                || others.contains(Token.EOF)
                || !(error.getInputStream() instanceof TokenStream tokens)) {
            return words;
        }
        Token before = SyntaxErrorMessage.before(tokens, error.getOffendingToken());
        if (before == null) {
            words.add(typeOf("'package'"));
        }
        if (before == null || before.getType() == ArcomatLexer.SEMICOLON) {
            words.add(typeOf("'import'"));
        }
        return words;
    }

    /** Where prediction died after looking ahead, its last configurations tell. */
    private static IntervalSet typesBehind(NoViableAltException error) {
        IntervalSet types = new IntervalSet();
        for (ATNConfig configuration : error.getDeadEndConfigs()) {
            for (Transition transition : configuration.state.getTransitions()) {
                if (!transition.isEpsilon() && transition.label() != null) {
                    types.addAll(transition.label());
                }
            }
        }
        return types;
    }

    /** At most a few alternatives, named tokens instead of sets of them; may be empty. */
    static List<String> words(Parser parser, RecognitionException error) {
        Expectation expectation = new Expectation(parser.getATN(), types(error));
        expectation.takeSets(error.getCtx() instanceof ParserRuleContext c ? c : null);
        expectation.takeTokens();
        return expectation.words;
    }

    private void takeSets(@Nullable ParserRuleContext context) {
        dropOperators();
        take(ArcomatParser.RULE_element, "an element of a component");
        if (context != null
                && context.getRuleIndex() == ArcomatParser.RULE_automaton
                && types.contains(ArcomatLexer.CLOSE_BRACE)) {
            take(ArcomatParser.RULE_automatonElement, "an element of an automaton");
        }
        take(ArcomatParser.RULE_typeDefinition, "the definition of a type");
        take(ArcomatParser.RULE_value, "a message");
        take(ArcomatParser.RULE_expression, "an expression");
        take(ArcomatParser.RULE_message, "a message");
        take(ArcomatParser.RULE_type, "a type");
        take(ArcomatParser.RULE_name, "a name");
    }

    /** Behind an operand any operator may stand: true everywhere, and of no help. */
    private void dropOperators() {
        if (types.size() == 1 || !containsOperators()) {
            return;
        }
        for (int type = 1; type <= ArcomatLexer.VOCABULARY.getMaxTokenType(); type++) {
            if (TokenKind.of(type).isOperator()) {
                types.remove(type);
            }
        }
        types.remove(typeOf("'['"));
    }

    private boolean containsOperators() {
        return types.contains(typeOf("'&&'")) && types.contains(typeOf("'*'"));
    }

    private static int typeOf(String literal) {
        for (int type = 1; type <= ArcomatLexer.VOCABULARY.getMaxTokenType(); type++) {
            if (literal.equals(ArcomatLexer.VOCABULARY.getLiteralName(type))) {
                return type;
            }
        }
        throw new AssertionError(literal);
    }

    private void take(int rule, String word) {
        IntervalSet first = atn.nextTokens(atn.ruleToStartState[rule]);
        if (first.subtract(types).isNil()) {
            words.add(word);
            for (int type : first.toArray()) {
                types.remove(type);
            }
        }
    }

    private void takeTokens() {
        for (String literal : TELLING) {
            takeToken(typeOf(literal));
        }
        int[] others = types.toArray();
        for (int type : others) {
            if (!isContinuation(type)) {
                takeToken(type);
            }
        }
        for (int type : others) {
            if (words.isEmpty()) {
                takeToken(type);
            }
        }
    }

    private void takeToken(int type) {
        if (types.contains(type) && type != Token.EPSILON && words.size() < MOST_WORDS) {
            words.add(wordFor(type));
            types.remove(type);
        }
    }

    /** What could prolong the text before it, hardly ever what the writer missed. */
    private static boolean isContinuation(int type) {
        String literal = ArcomatLexer.VOCABULARY.getLiteralName(type);
        return literal != null && CONTINUATIONS.contains(literal);
    }

    private static String wordFor(int type) {
        if (type == Token.EOF) {
            return "the end of the file";
        }
        String literal = ArcomatLexer.VOCABULARY.getLiteralName(type);
        if (literal != null) {
            return literal;
        }
        return switch (type) {
            case ArcomatLexer.INT -> "a whole number";
            case ArcomatLexer.STRING -> "a string";
            default -> "a value";
        };
    }
}
