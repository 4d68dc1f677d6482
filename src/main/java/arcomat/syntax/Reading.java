package arcomat.syntax;

import arcomat.source.Diagnostic;
import arcomat.source.SourceFile;
import arcomat.syntax.antlr.ArcomatLexer;
import arcomat.syntax.antlr.ArcomatParser;
import arcomat.syntax.runtime.EarlierFirst;
import arcomat.syntax.runtime.FilledTokens;
import arcomat.tree.Unit.Comment;

import org.antlr.v4.runtime.ANTLRErrorStrategy;
import org.antlr.v4.runtime.BailErrorStrategy;
import org.antlr.v4.runtime.CommonTokenStream;
import org.antlr.v4.runtime.ParserRuleContext;
import org.antlr.v4.runtime.Token;
import org.antlr.v4.runtime.atn.PredictionMode;
import org.antlr.v4.runtime.misc.ParseCancellationException;
import org.jspecify.annotations.Nullable;

import java.util.ArrayList;
import java.util.List;
import java.util.function.Function;
import java.util.function.Supplier;

/**
 * A file as ANTLR sees it: tokens, comments, parse tree. With findings the tree has gaps.
 *
 * @param root what the entry rule of the file's language returned; null where the tokens alone are
 *     reason enough not to parse
 */
record Reading(
        SourceFile file,
        CommonTokenStream tokens,
        List<Comment> comments,
        @Nullable ParserRuleContext root,
        List<Diagnostic> findings) {

    /** Whether the parse tree of a text without errors has its tokens: trees are built without. */
    enum Leaves {
        KEPT,
        OMITTED
    }

    /**
     * Calls what recurses as deep as a text nests.
     *
     * @param <T> what it returns
     */
    @FunctionalInterface
    interface Depth<T> {
        T call(Supplier<T> task);
    }

    /** From this depth on parse trees are built and walked on a stack of their own. */
    private static final int DEEP = 100;

    /** Reads a file and gives the reading to a task that may recurse as deep as the text nests. */
    static <T> T use(SourceFile file, Leaves leaves, Function<Reading, T> task) {
        return use(file, leaves, NestingGuard.LIMIT, DeepStack::call, task);
    }

    /**
     * The same where somebody else has room for what is nested deeply.
     *
     * @param limit what is nested in more levels is not read
     */
    static <T> T use(
            SourceFile file, Leaves leaves, int limit, Depth<T> depth, Function<Reading, T> task) {
        CommonTokenStream tokens = tokens(file);
        TokenChecks checks = TokenChecks.of(file, tokens.getTokens(), limit);
        if (checks.depth() < DEEP || !checks.findings().isEmpty()) {
            return task.apply(of(file, tokens, leaves, checks.findings()));
        }
        return depth.call(() -> task.apply(of(file, tokens, leaves, checks.findings())));
    }

    private static Reading of(
            SourceFile file, CommonTokenStream tokens, Leaves leaves, List<Diagnostic> findings) {
        ParserRuleContext root = null;
        if (findings.isEmpty()) {
            root = parseFast(file, tokens, leaves);
            if (root == null) {
                root = parseSlow(file, tokens, findings);
            }
        }
        return new Reading(file, tokens, comments(file, tokens), root, findings);
    }

    static CommonTokenStream tokens(SourceFile file) {
        return FilledTokens.of(file, ArcomatLexer::new);
    }

    private static List<Comment> comments(SourceFile file, CommonTokenStream tokens) {
        List<Comment> comments = new ArrayList<>();
        for (Token token : tokens.getTokens()) {
            if (token.getChannel() == Token.HIDDEN_CHANNEL) {
                comments.add(
                        new Comment(
                                file.span(token.getStartIndex(), token.getStopIndex() + 1),
                                token.getText()));
            }
        }
        return List.copyOf(comments);
    }

    /** Null where the fast mode finds no tree. */
    private static @Nullable ParserRuleContext parseFast(
            SourceFile file, CommonTokenStream tokens, Leaves leaves) {
        ArcomatParser parser = parser(tokens, new BailErrorStrategy(), PredictionMode.SLL);
        if (leaves == Leaves.OMITTED) {
            parser.omitLeaves();
        }
        try {
            return Language.of(file).enter(parser);
        } catch (ParseCancellationException e) {
            return null;
        }
    }

    /**
     * Finds the syntax errors in a text that the fast mode rejected, which might be a good one.
     *
     * @param findings gets what is wrong, in text order
     * @return the parse tree; where something is wrong, with gaps
     */
    private static ParserRuleContext parseSlow(
            SourceFile file, CommonTokenStream tokens, List<Diagnostic> findings) {
        tokens.seek(0);
        Recovery recovery = new Recovery(file, findings);
        return Language.of(file).enter(parser(tokens, recovery, PredictionMode.LL));
    }

    private static ArcomatParser parser(
            CommonTokenStream tokens, ANTLRErrorStrategy strategy, PredictionMode mode) {
        ArcomatParser parser = new ArcomatParser(tokens);
        parser.removeErrorListeners();
        parser.setErrorHandler(strategy);
        // "a == b" is an equation and an expression; an equation goes on as the expression would.
        parser.setInterpreter(new EarlierFirst(parser, ArcomatParser.RULE_item));
        parser.getInterpreter().setPredictionMode(mode);
        return parser;
    }
}
