package arcomat.generate.views;

import arcomat.generate.text.ExpressionWriter;
import arcomat.generate.text.FileContext;
import arcomat.generate.text.Formula;
import arcomat.generate.text.MemberNames;
import arcomat.generate.view.AtomicView.ConditionView;

import java.util.ArrayList;
import java.util.List;

/**
 * Conditions of transitions. Virtual machines do not compile long methods, and have no room for
 * very long ones: of a long row of operands some share a method each.
 */
final class LongConditions {
    private final ExpressionWriter expressions;
    private final MemberNames members;
    private final List<ConditionView> methods = new ArrayList<>();

    LongConditions(FileContext context) {
        this.expressions = context.expressions();
        this.members = context.members();
    }

    /** The text of a condition, with calls of methods where it is long. */
    String text(int transition, Formula condition) {
        return expressions.of(new Cutting(transition).shortened(condition)).text();
    }

    /** The methods that were called for, in that order. */
    List<ConditionView> methods() {
        return methods;
    }

    /** One condition that is cut into parts. */
    private final class Cutting {
        private final int transition;
        private int parts;

        Cutting(int transition) {
            this.transition = transition;
        }

        private Formula shortened(Formula f) {
            if (!expressions.calls() || MethodSize.fits(expressions.of(f).text())) {
                return f;
            }
            if (f instanceof Formula.Not not) {
                return new Formula.Not(shortened(not.operand()));
            }
            return f instanceof Formula.Row row ? shortened(row.operands(), row.all()) : f;
        }

        private Formula shortened(List<Formula> operands, boolean all) {
            List<Formula> calls = new ArrayList<>();
            List<Formula> some = new ArrayList<>();
            int size = 0;
            for (Formula operand : operands) {
                Formula part = shortened(operand);
                int more = MethodSize.of(expressions.of(part).text());
                if (!some.isEmpty() && size + more > MethodSize.MOST) {
                    calls.add(call(Formula.Row.of(all, some)));
                    some.clear();
                    size = 0;
                }
                some.add(part);
                size += more;
            }
            Formula rest = Formula.Row.of(all, some);
            calls.add(calls.isEmpty() ? rest : call(rest));
            return calls.size() == 1 ? rest : shortened(Formula.Row.of(all, calls));
        }

        private Formula call(Formula condition) {
            String method = members.local("condition" + transition + "part", parts++);
            methods.add(new ConditionView(method, expressions.of(condition).text()));
            return Formula.Test.of(expressions.call(method), true);
        }
    }
}
