package arcomat.syntax.build;

import arcomat.syntax.antlr.ArcomatParser;

import org.antlr.v4.runtime.BailErrorStrategy;
import org.antlr.v4.runtime.CommonToken;
import org.antlr.v4.runtime.CommonTokenStream;
import org.antlr.v4.runtime.ListTokenSource;
import org.antlr.v4.runtime.Token;
import org.antlr.v4.runtime.misc.ParseCancellationException;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;

/**
 * The text of an invariant. It may be of any language, so the grammar takes it as it is; where its
 * tokens form an expression of models, it is one.
 */
final class InvariantBody {
    private InvariantBody() {}

    /**
     * @param tokens all those of the file
     */
    static Optional<ArcomatParser.ExpressionContext> condition(
            ArcomatParser.InvariantBodyContext body, List<Token> tokens) {
        if (body.javaBlock() != null) {
            return Optional.empty();
        }
        List<Token> own = new ArrayList<>();
        for (int i = body.start.getTokenIndex(); i <= body.stop.getTokenIndex(); i++) {
            // A copy, since a stream numbers its tokens.
            own.add(new CommonToken(tokens.get(i)));
        }
        ArcomatParser parser = new ArcomatParser(new CommonTokenStream(new ListTokenSource(own)));
        parser.removeErrorListeners();
        parser.setErrorHandler(new BailErrorStrategy());
        try {
            return Optional.of(parser.expressionUnit().expression());
        } catch (ParseCancellationException anotherLanguage) {
            return Optional.empty();
        }
    }
}
