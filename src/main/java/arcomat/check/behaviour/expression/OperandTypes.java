package arcomat.check.behaviour.expression;

import arcomat.symbols.expressions.ExpressionProblem.Kind;

/** ARC0330: operators and casts are used on the types that they are made for. */
public final class OperandTypes extends ProblemLaw {

    OperandTypes() {
        super(Kind.OPERAND_TYPE, Kind.CAST, Kind.ABSENCE_OF_NO_PORT);
    }
}
