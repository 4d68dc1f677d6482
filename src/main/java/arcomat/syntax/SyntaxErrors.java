package arcomat.syntax;

import arcomat.source.Diagnostic;
import arcomat.source.SourceFile;
import arcomat.syntax.antlr.ArcomatParser;

import org.antlr.v4.runtime.BaseErrorListener;
import org.antlr.v4.runtime.CommonTokenStream;
import org.antlr.v4.runtime.ParserRuleContext;
import org.antlr.v4.runtime.RecognitionException;
import org.antlr.v4.runtime.Recognizer;
import org.antlr.v4.runtime.Token;

import java.util.List;

final class SyntaxErrors {
    private SyntaxErrors() {}

    static ParserRuleContext parse(
            SourceFile file, CommonTokenStream tokens, List<Diagnostic> findings) {
        tokens.seek(0);
        ArcomatParser parser = new ArcomatParser(tokens);
        parser.removeErrorListeners();
        parser.addErrorListener(
                new BaseErrorListener() {
                    @Override
                    public void syntaxError(
                            Recognizer<?, ?> recognizer,
                            Object symbol,
                            int line,
                            int column,
                            String message,
                            RecognitionException e) {
                        Token t = (Token) symbol;
                        findings.add(
                                Diagnostic.error(
                                        "ARC0001",
                                        file.span(t.getStartIndex(), t.getStartIndex()),
                                        message));
                    }
                });
        ParserRuleContext root = Language.of(file).enter(parser);
        return findings.isEmpty() ? root : null;
    }
}
