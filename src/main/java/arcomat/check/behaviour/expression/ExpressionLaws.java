package arcomat.check.behaviour.expression;

import static arcomat.check.law.Law.Needs.NAMES;
import static arcomat.check.law.Law.error;
import static arcomat.check.law.Law.warning;

import arcomat.check.law.Law;

import java.util.List;

/** One line for each law of this folder, in alphabetical order. */
public final class ExpressionLaws {
    public static final List<Law> LAWS =
            List.of(
                    error("ARC0346", new BoundNameFree()),
                    error("ARC0323", new DivisionByZeroLiteral()),
                    error("ARC0347", new FiniteDomain()),
                    error("ARC0309", new InitialReadsNoInput()),
                    error("ARC0331", new LiteralFits()),
                    error("ARC0322", new LiteralInRange()),
                    error("ARC0329", new NameExists()).needing(NAMES),
                    warning("ARC0348", new OctalNumber()),
                    error("ARC0330", new OperandTypes()),
                    error("ARC0308", new OutputPortNotRead()),
                    error("ARC0332", new RangeWellFormed()),
                    error("ARC0319", new SupportedExpression()).needing(NAMES));

    private ExpressionLaws() {}
}
