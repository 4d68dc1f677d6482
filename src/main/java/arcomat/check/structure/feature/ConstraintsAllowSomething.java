package arcomat.check.structure.feature;

import arcomat.check.law.Check;
import arcomat.symbols.names.Variants;
import arcomat.tree.Component;
import arcomat.tree.Expression;
import arcomat.tree.Unit;

import java.util.ArrayList;
import java.util.List;

/** ARC0151: the constraints of a component allow at least one configuration of its features. */
public final class ConstraintsAllowSomething implements Check.OnUnit {

    @Override
    public void check(Unit unit, Context context, Findings findings) {
        if (unit.definition() instanceof Component component) {
            Variants.orConstraintsOf(component)
                    .filter(ConstraintsAllowSomething::isContradictory)
                    .ifPresent(each -> report(each, findings));
        }
    }

    private static boolean isContradictory(Variants variants) {
        return variants.features().size() <= Variants.MOST_FEATURES
                && variants.configurations().isEmpty();
    }

    private static void report(Variants variants, Findings findings) {
        List<Expression> core = core(variants);
        Expression last = core.get(core.size() - 1);
        findings.report(last, message(variants, core), variants.node().name());
        core.subList(0, core.size() - 1)
                .forEach(each -> findings.related(each, "contradicts with the others"));
    }

    private static String message(Variants variants, List<Expression> core) {
        if (variants.features().isEmpty()) {
            return "this constraint is false; no instance of '%s' can be; correct it";
        }
        return core.size() == 1
                ? "no choice of features makes this constraint true; no instance of '%s' can be;"
                        + " correct it"
                : "no choice of features makes this constraint and those before it true; no"
                        + " instance of '%s' can be; correct one of them";
    }

    /** Constraints that contradict each other, and would not if one of them were left out. */
    private static List<Expression> core(Variants variants) {
        List<Expression> core = new ArrayList<>(variants.constraints());
        for (Expression each : variants.constraints()) {
            List<Expression> others = new ArrayList<>(core);
            others.remove(each);
            Variants without = new Variants(variants.node(), variants.features(), others);
            if (without.configurations().isEmpty()) {
                core = others;
            }
        }
        return core;
    }
}
