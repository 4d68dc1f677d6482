package arcomat.check.behaviour.expression;

import arcomat.check.law.Findings;
import arcomat.source.Fix;
import arcomat.symbols.expressions.ExpressionProblem;
import arcomat.symbols.expressions.PortSymbol;
import arcomat.symbols.expressions.Typed;
import arcomat.symbols.expressions.TypedExpression;

import java.util.Optional;
import java.util.Set;

/** What several laws about expressions share. */
final class Expressions {
    private Expressions() {}

    /** The port that an expression reads, or whose silence it asks for; its parts not looked at. */
    static Optional<PortSymbol> portRead(TypedExpression expression) {
        if (expression instanceof TypedExpression.PortRead read) {
            return Optional.of(read.port());
        }
        if (expression instanceof TypedExpression.Absence absence) {
            return Optional.of(absence.port());
        }
        return Optional.empty();
    }

    /** Reports the problems of some kinds. */
    static void report(Typed typed, Set<ExpressionProblem.Kind> kinds, Findings findings) {
        for (ExpressionProblem problem : typed.problems()) {
            if (kinds.contains(problem.kind())) {
                report(problem, findings);
            }
        }
    }

    static void report(ExpressionProblem problem, Findings findings) {
        findings.report(problem.span(), problem.message());
        problem.suggestion()
                .ifPresent(
                        name ->
                                findings.fix(
                                        Fix.replace(
                                                "Change to '" + name + "'", problem.span(), name)));
    }
}
