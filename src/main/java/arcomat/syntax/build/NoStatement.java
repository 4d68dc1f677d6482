package arcomat.syntax.build;

import arcomat.syntax.antlr.ArcomatParser;

import org.antlr.v4.runtime.BailErrorStrategy;
import org.antlr.v4.runtime.CommonToken;
import org.antlr.v4.runtime.CommonTokenStream;
import org.antlr.v4.runtime.ListTokenSource;
import org.antlr.v4.runtime.RecognitionException;
import org.antlr.v4.runtime.Token;
import org.antlr.v4.runtime.misc.ParseCancellationException;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;

/** Why a block that may be of another language is no row of statements. */
final class NoStatement {
    private NoStatement() {}

    /**
     * The first token at which nobody can go on to a statement.
     *
     * @param tokens all those of the file
     */
    static Optional<Token> in(ArcomatParser.JavaBlockContext block, List<Token> tokens) {
        List<Token> own = new ArrayList<>();
        for (int i = block.start.getTokenIndex(); i <= block.stop.getTokenIndex(); i++) {
            // A copy, since a stream numbers its tokens.
            own.add(new CommonToken(tokens.get(i)));
        }
        ArcomatParser parser = new ArcomatParser(new CommonTokenStream(new ListTokenSource(own)));
        parser.removeErrorListeners();
        parser.setErrorHandler(new BailErrorStrategy());
        try {
            parser.statements();
            return Optional.empty();
        } catch (ParseCancellationException mistake) {
            return mistake.getCause() instanceof RecognitionException at
                    ? Optional.ofNullable(at.getOffendingToken())
                            .filter(token -> token.getType() != Token.EOF)
                    : Optional.empty();
        }
    }
}
