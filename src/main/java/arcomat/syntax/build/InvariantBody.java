package arcomat.syntax.build;

import arcomat.syntax.antlr.ArcomatParser;

import org.antlr.v4.runtime.BailErrorStrategy;
import org.antlr.v4.runtime.CommonToken;
import org.antlr.v4.runtime.CommonTokenStream;
import org.antlr.v4.runtime.ListTokenSource;
import org.antlr.v4.runtime.Token;
import org.antlr.v4.runtime.misc.ParseCancellationException;
import org.antlr.v4.runtime.tree.ParseTree;
import org.antlr.v4.runtime.tree.TerminalNode;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;

/**
 * The text of an invariant. It may be of any language, so the grammar takes it as it is; where its
 * tokens form an expression of models, it is one.
 */
final class InvariantBody {
    private InvariantBody() {}

    static Optional<ArcomatParser.ExpressionContext> condition(
            ArcomatParser.InvariantBodyContext body) {
        if (body.javaBlock() != null || body.children == null) {
            return Optional.empty();
        }
        List<Token> tokens = new ArrayList<>();
        for (ParseTree child : body.children) {
            if (child instanceof TerminalNode leaf) {
                // A copy, since a stream numbers its tokens.
                tokens.add(new CommonToken(leaf.getSymbol()));
            }
        }
        ArcomatParser parser =
                new ArcomatParser(new CommonTokenStream(new ListTokenSource(tokens)));
        parser.removeErrorListeners();
        parser.setErrorHandler(new BailErrorStrategy());
        try {
            return Optional.of(parser.expressionUnit().expression());
        } catch (ParseCancellationException anotherLanguage) {
            return Optional.empty();
        }
    }
}
