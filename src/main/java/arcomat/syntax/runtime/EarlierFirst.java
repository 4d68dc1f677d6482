package arcomat.syntax.runtime;

import org.antlr.v4.runtime.Parser;
import org.antlr.v4.runtime.ParserRuleContext;
import org.antlr.v4.runtime.TokenStream;
import org.antlr.v4.runtime.atn.ParserATNSimulator;
import org.antlr.v4.runtime.atn.PredictionMode;

/**
 * Foretells which alternative a parser takes, where one rule means it so that the earlier of two
 * alternatives that fit is the right one. ANTLR's exact mode finds out each time anew, with the
 * rules that are being read, that both fit, and takes the earlier one; here that is in the table
 * which all parsers share, as it is in ANTLR's fast mode.
 */
public final class EarlierFirst extends ParserATNSimulator {
    private final int rule;

    /**
     * @param rule whose earlier alternatives can go on with whatever the later ones can, once both
     *     fit: behind that, there is nothing that only the exact mode would know
     */
    public EarlierFirst(Parser parser, int rule) {
        super(
                parser,
                parser.getATN(),
                parser.getInterpreter().decisionToDFA,
                parser.getInterpreter().getSharedContextCache());
        this.rule = rule;
    }

    @Override
    public int adaptivePredict(TokenStream input, int decision, ParserRuleContext context) {
        if (atn.getDecisionState(decision).ruleIndex != rule) {
            return super.adaptivePredict(input, decision, context);
        }
        PredictionMode mode = getPredictionMode();
        setPredictionMode(PredictionMode.SLL);
        try {
            return super.adaptivePredict(input, decision, context);
        } finally {
            setPredictionMode(mode);
        }
    }
}
