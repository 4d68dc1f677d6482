package arcomat.syntax.runtime;

import org.antlr.v4.runtime.Parser;
import org.antlr.v4.runtime.Token;
import org.antlr.v4.runtime.TokenStream;

/** What the generated parser extends: a parser whose trees may have leaves or not. */
public abstract class TreeParser extends Parser {
    private boolean leaves = true;

    protected TreeParser(TokenStream tokens) {
        super(tokens);
    }

    /**
     * Leaves the tokens out of the parse tree. Who asks for labels and productions sees no
     * difference; the strategy for errors must not go on behind one, since that makes leaves, too.
     */
    public final void omitLeaves() {
        leaves = false;
    }

    @Override
    public Token consume() {
        if (leaves) {
            return super.consume();
        }
        Token token = getCurrentToken();
        if (token.getType() != Token.EOF) {
            getInputStream().consume();
        }
        return token;
    }
}
