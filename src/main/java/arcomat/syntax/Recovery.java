package arcomat.syntax;

import arcomat.source.Diagnostic;
import arcomat.source.RestOfFile;
import arcomat.source.SourceFile;
import arcomat.syntax.antlr.ArcomatLexer;
import arcomat.syntax.antlr.ArcomatParser;

import org.antlr.v4.runtime.DefaultErrorStrategy;
import org.antlr.v4.runtime.InputMismatchException;
import org.antlr.v4.runtime.Parser;
import org.antlr.v4.runtime.ParserRuleContext;
import org.antlr.v4.runtime.RecognitionException;
import org.antlr.v4.runtime.Token;
import org.antlr.v4.runtime.TokenStream;
import org.antlr.v4.runtime.atn.ATNState;
import org.antlr.v4.runtime.misc.IntervalSet;

import java.util.List;
import java.util.Set;

/**
 * Reports one error per element and goes on behind it. An element is what stands in the braces of a
 * definition and ends with a semicolon or a body of its own; an error unwinds the parser to the
 * innermost one. Nothing is guessed inside an element: that is what makes errors cascade.
 */
final class Recovery extends DefaultErrorStrategy {
    /** Of a file; that there are more is one more finding. */
    private static final int MOST_FINDINGS = 50;

    /** Contexts that are followed by a sibling or by the brace that closes their parent. */
    private static final Set<Integer> ELEMENTS =
            Set.of(
                    ArcomatParser.RULE_packageDeclaration,
                    ArcomatParser.RULE_importDeclaration,
                    ArcomatParser.RULE_element,
                    ArcomatParser.RULE_automatonElement,
                    ArcomatParser.RULE_statement,
                    ArcomatParser.RULE_tableInputs,
                    ArcomatParser.RULE_tableOutputs,
                    ArcomatParser.RULE_row,
                    ArcomatParser.RULE_typeDefinition,
                    ArcomatParser.RULE_typeMember,
                    ArcomatParser.RULE_suiteMember,
                    ArcomatParser.RULE_testPart,
                    ArcomatParser.RULE_portStream,
                    ArcomatParser.RULE_eventStream);

    /** Elements that may have a body. */
    private static final Set<Integer> WITH_BODY =
            Set.of(
                    ArcomatParser.RULE_element,
                    ArcomatParser.RULE_statement,
                    ArcomatParser.RULE_typeDefinition,
                    ArcomatParser.RULE_suiteMember,
                    ArcomatParser.RULE_testPart);

    /** Contexts whose braces hold elements. */
    private static final Set<Integer> BODIES =
            Set.of(
                    ArcomatParser.RULE_component,
                    ArcomatParser.RULE_automaton,
                    ArcomatParser.RULE_statements,
                    ArcomatParser.RULE_variation,
                    ArcomatParser.RULE_alternative,
                    ArcomatParser.RULE_implementation,
                    ArcomatParser.RULE_ioTable,
                    ArcomatParser.RULE_classDiagram,
                    ArcomatParser.RULE_typeDefinition,
                    ArcomatParser.RULE_typeBody,
                    ArcomatParser.RULE_testSuite,
                    ArcomatParser.RULE_suiteMember,
                    ArcomatParser.RULE_testPart);

    private final SourceFile file;
    private final List<Diagnostic> findings;

    /** Index of the first token behind the text skipped last, and the line of that error. */
    private int resumedAt = -1;

    private int lineOfLastError;
    private boolean endReported;

    Recovery(SourceFile file, List<Diagnostic> findings) {
        this.file = file;
        this.findings = findings;
    }

    @Override
    public Token recoverInline(Parser parser) {
        throw new InputMismatchException(parser);
    }

    /** Looks ahead at loops and options, where the list of what may follow is still complete. */
    @Override
    public void sync(Parser parser) {
        if (inErrorRecoveryMode(parser)) {
            return;
        }
        ATNState state = parser.getInterpreter().atn.states.get(parser.getState());
        IntervalSet next = parser.getATN().nextTokens(state);
        if (next.contains(Token.EPSILON) || next.contains(parser.getInputStream().LA(1))) {
            return;
        }
        InputMismatchException error = new InputMismatchException(parser);
        if (!BODIES.contains(parser.getContext().getRuleIndex())
                || !next.contains(ArcomatLexer.CLOSE_BRACE)) {
            throw error;
        }
        reportError(parser, error);
        skipStrays(parser, next);
        endErrorCondition(parser);
    }

    /** Skips what cannot begin an element, up to what can or to the end of the body. */
    private void skipStrays(Parser parser, IntervalSet next) {
        TokenStream tokens = parser.getInputStream();
        while (tokens.LA(1) != Token.EOF && !next.contains(tokens.LA(1))) {
            skip(parser, tokens.index(), true);
        }
    }

    @Override
    public void reportError(Parser parser, RecognitionException error) {
        if (inErrorRecoveryMode(parser)) {
            return;
        }
        beginErrorCondition(parser);
        Token found = error.getOffendingToken();
        if (!isEcho(error) && !endReported) {
            tell(parser, error);
        }
        lineOfLastError = found.getLine();
        endReported |= found.getType() == Token.EOF;
    }

    private void tell(Parser parser, RecognitionException error) {
        if (findings.size() <= MOST_FINDINGS) {
            Diagnostic finding = new SyntaxErrorMessage(file, parser, error).finding();
            findings.add(
                    findings.size() < MOST_FINDINGS
                            ? finding
                            : RestOfFile.from(finding.span(), MOST_FINDINGS));
        }
    }

    /** The rest of a line that was skipped in part says nothing new. */
    private boolean isEcho(RecognitionException error) {
        if (resumedAt < 0 || !(error.getCtx() instanceof ParserRuleContext context)) {
            return false;
        }
        int start =
                Math.min(context.start.getTokenIndex(), error.getOffendingToken().getTokenIndex());
        return start <= resumedAt && error.getOffendingToken().getLine() == lineOfLastError;
    }

    @Override
    public void recover(Parser parser, RecognitionException error) {
        ParserRuleContext context = parser.getContext();
        boolean onlySemicolonMissing = SyntaxErrorMessage.isSemicolonMissing(parser, error);
        if (onlySemicolonMissing && error instanceof InputMismatchException) {
            // All else is there: it can be read as if it were whole.
            context.exception = null;
        }
        if (isElement(context)) {
            if (onlySemicolonMissing) {
                skipTo(parser, error.getOffendingToken().getTokenIndex());
            } else {
                skip(
                        parser,
                        context.start.getTokenIndex(),
                        WITH_BODY.contains(context.getRuleIndex()));
            }
            endErrorCondition(parser);
        } else if (context.getParent() != null) {
            throw error;
        }
    }

    private void skip(Parser parser, int start, boolean hasBody) {
        TokenStream tokens = parser.getInputStream();
        int rule = parser.getContext().getRuleIndex();
        boolean isStatement =
                rule == ArcomatParser.RULE_statement || rule == ArcomatParser.RULE_statements;
        skipTo(parser, ElementEnd.find(tokens, start, tokens.index(), hasBody, isStatement));
        resumedAt = tokens.index();
    }

    /** A prediction that fails has consumed nothing: the parser may still stand at the start. */
    private static void skipTo(Parser parser, int end) {
        TokenStream tokens = parser.getInputStream();
        while (tokens.index() < end && tokens.LA(1) != Token.EOF) {
            parser.consume();
        }
    }

    static boolean isElement(ParserRuleContext context) {
        return ELEMENTS.contains(context.getRuleIndex());
    }
}
