package arcomat.check.behaviour.expression;

import arcomat.check.law.Check;
import arcomat.source.Fix;
import arcomat.symbols.expressions.ExpressionProblem;
import arcomat.symbols.expressions.ExpressionProblem.Kind;
import arcomat.symbols.expressions.Typed;

import java.util.Set;

/** Reports what typing has found wrong in expressions: the problems of some kinds. */
abstract class ProblemLaw implements Check.OnExpression {
    private final Set<Kind> kinds;

    ProblemLaw(Kind... kinds) {
        this.kinds = Set.of(kinds);
    }

    /** Whether no other law is about a problem of these kinds. */
    boolean isOwn(ExpressionProblem problem, Context context) {
        return true;
    }

    @Override
    public void check(Typed typed, Context context, Findings findings) {
        for (ExpressionProblem problem : typed.problems()) {
            if (kinds.contains(problem.kind()) && isOwn(problem, context)) {
                report(problem, findings);
            }
        }
    }

    private static void report(ExpressionProblem problem, Findings findings) {
        findings.report(problem.span(), problem.message());
        problem.suggestion()
                .map(name -> Fix.replace("Change to '" + name + "'", problem.span(), name))
                .ifPresent(findings::fix);
    }
}
