package arcomat.generate;

import arcomat.generate.language.Text;
import arcomat.generate.view.ConditionView;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;

/**
 * Conditions of transitions. Virtual machines do not compile long methods, and have no room for
 * very long ones: of a long row of operands some share a method each.
 */
final class Conditions {
    private final ExpressionText expressions;
    private final Members members;
    private final Map<String, String> methods = new LinkedHashMap<>();
    private int transition;
    private int parts;

    Conditions(FileContext context) {
        this.expressions = context.expressions();
        this.members = context.members();
    }

    /** The text of a condition, with calls of methods where it is long. */
    String text(int newTransition, Formula condition) {
        transition = newTransition;
        parts = 0;
        return expressions.text(shortened(condition)).text();
    }

    /** The methods that were called for, in that order. */
    List<ConditionView> methods() {
        List<ConditionView> views = new ArrayList<>();
        methods.forEach((name, text) -> views.add(new ConditionView(name, text)));
        return views;
    }

    private Formula shortened(Formula f) {
        if (!expressions.calls() || MethodSize.fits(expressions.text(f).text())) {
            return f;
        }
        if (f instanceof Formula.Not not) {
            return new Formula.Not(shortened(not.operand()));
        }
        if (f instanceof Formula.And and) {
            return shortened(and.operands(), true);
        }
        return f instanceof Formula.Or or ? shortened(or.operands(), false) : f;
    }

    private Formula shortened(List<Formula> operands, boolean and) {
        List<Formula> calls = new ArrayList<>();
        List<Formula> some = new ArrayList<>();
        int size = 0;
        for (Formula operand : operands) {
            Formula part = shortened(operand);
            int more = MethodSize.of(expressions.text(part).text());
            if (!some.isEmpty() && size + more > MethodSize.MOST) {
                calls.add(call(row(some, and)));
                some.clear();
                size = 0;
            }
            some.add(part);
            size += more;
        }
        calls.add(calls.isEmpty() ? row(some, and) : call(row(some, and)));
        return calls.size() == 1 ? calls.get(0) : shortened(row(calls, and));
    }

    private static Formula row(List<Formula> operands, boolean and) {
        if (operands.size() == 1) {
            return operands.get(0);
        }
        return and ? new Formula.And(List.copyOf(operands)) : new Formula.Or(List.copyOf(operands));
    }

    private Formula call(Formula condition) {
        String method = members.local("condition" + transition + "part", String.valueOf(parts++));
        methods.put(method, expressions.text(condition).text());
        Text call = expressions.call(method);
        return Formula.Test.of(call, true);
    }
}
