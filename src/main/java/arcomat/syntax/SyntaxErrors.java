package arcomat.syntax;

import arcomat.source.Diagnostic;
import arcomat.source.SourceFile;
import arcomat.syntax.antlr.ArcomatParser;

import org.antlr.v4.runtime.CommonTokenStream;
import org.antlr.v4.runtime.ParserRuleContext;
import org.antlr.v4.runtime.atn.PredictionMode;

import java.util.List;

/** The second, slow way through a text that the fast one rejected: it finds the syntax errors. */
final class SyntaxErrors {
    private SyntaxErrors() {}

    /**
     * Adds what is wrong, in text order.
     *
     * @return the parse tree; where something is wrong, with gaps
     */
    static ParserRuleContext parse(
            SourceFile file, CommonTokenStream tokens, List<Diagnostic> findings) {
        tokens.seek(0);
        ArcomatParser parser = new ArcomatParser(tokens);
        parser.removeErrorListeners();
        parser.setErrorHandler(new Recovery(file, findings));
        parser.getInterpreter().setPredictionMode(PredictionMode.LL);
        return Language.of(file).enter(parser);
    }
}
