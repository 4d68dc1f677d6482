package arcomat.check.naming;

import arcomat.check.behaviour.item.Items;
import arcomat.check.law.Check;
import arcomat.check.law.Context;
import arcomat.check.law.Findings;
import arcomat.check.law.Law;
import arcomat.symbols.bodies.AutomatonSymbol;
import arcomat.symbols.expressions.ValueSymbol;

import java.util.HashMap;
import java.util.List;
import java.util.Map;

/** ARC0212: an automaton declares no variable, no input and no output twice. */
public final class VariableDeclaredOnce implements Check.OnAutomaton {

    @Override
    public Law law() {
        return Law.error("ARC0212");
    }

    @Override
    public void check(AutomatonSymbol automaton, Context context, Findings findings) {
        check(automaton.declaredPorts(), findings);
        check(automaton.variables(), findings);
    }

    private static void check(List<? extends ValueSymbol> values, Findings findings) {
        Map<String, ValueSymbol> seen = new HashMap<>();
        for (ValueSymbol value : values) {
            ValueSymbol first = seen.putIfAbsent(value.name(), value);
            if (first != null) {
                findings.report(
                                value.nameSpan(),
                                Items.words(value) + " is declared twice; remove or rename one")
                        .related(first.nameSpan(), "first declared here");
            }
        }
    }
}
