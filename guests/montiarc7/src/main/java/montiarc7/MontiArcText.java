package montiarc7;

import arcomat.source.SourceFile;

import montiarc7.grammar.MontiArc7Lexer;
import montiarc7.grammar.MontiArc7Parser;
import montiarc7.grammar.MontiArc7Parser.MappingContext;
import montiarc7.grammar.MontiArc7Parser.UnitContext;
import montiarc7.source.Lack;
import montiarc7.source.Lacks;

import org.antlr.v4.runtime.BaseErrorListener;
import org.antlr.v4.runtime.CharStreams;
import org.antlr.v4.runtime.CommonTokenStream;
import org.antlr.v4.runtime.ParserRuleContext;
import org.antlr.v4.runtime.RecognitionException;
import org.antlr.v4.runtime.Recognizer;
import org.antlr.v4.runtime.Token;

import java.util.List;

/** One file that was read. */
final class MontiArcText {
    private final UnitContext unit;
    private final CommonTokenStream tokens;

    private MontiArcText(UnitContext unit, CommonTokenStream tokens) {
        this.unit = unit;
        this.tokens = tokens;
    }

    /** What cannot be read is told at the first place where it cannot. */
    static MontiArcText of(SourceFile file, Lacks lacks) {
        MontiArc7Parser parser = parser(file, lacks);
        return new MontiArcText(parser.unit(), (CommonTokenStream) parser.getTokenStream());
    }

    /** A map of MontiArc's conformance. */
    static MappingContext mapping(SourceFile file, Lacks lacks) {
        return parser(file, lacks).mapping();
    }

    private static MontiArc7Parser parser(SourceFile file, Lacks lacks) {
        MontiArc7Lexer lexer = new MontiArc7Lexer(CharStreams.fromString(file.text()));
        MontiArc7Parser parser = new MontiArc7Parser(new CommonTokenStream(lexer));
        BaseErrorListener listener = listener(lacks);
        lexer.removeErrorListeners();
        lexer.addErrorListener(listener);
        parser.removeErrorListeners();
        parser.addErrorListener(listener);
        return parser;
    }

    private static BaseErrorListener listener(Lacks lacks) {
        return new BaseErrorListener() {
            @Override
            public void syntaxError(
                    Recognizer<?, ?> recognizer,
                    Object symbol,
                    int line,
                    int column,
                    String message,
                    RecognitionException e) {
                if (symbol instanceof Token token) {
                    int start = token.getStartIndex();
                    int end = Math.max(start + 1, token.getStopIndex() + 1);
                    String text =
                            token.getType() == Token.EOF ? "the end" : "'" + token.getText() + "'";
                    lacks.missing(
                            Lack.UNREADABLE,
                            lacks.offsets(start, end),
                            text
                                    + " is not what the importer expects here; write it otherwise,"
                                    + " or leave it out");
                } else {
                    lacks.missing(
                            Lack.UNREADABLE,
                            lacks.offsets(0, 1),
                            "there is a letter that cannot be read");
                }
            }
        };
    }

    UnitContext unit() {
        return unit;
    }

    /** The comments in front of something, each on a line of its own. */
    String comments(ParserRuleContext place) {
        List<Token> before = tokens.getHiddenTokensToLeft(place.getStart().getTokenIndex());
        StringBuilder text = new StringBuilder();
        if (before != null) {
            before.forEach(each -> text.append(each.getText()).append('\n'));
        }
        return text.toString();
    }
}
