package arcomat.check.naming;

import arcomat.check.behaviour.item.Items;
import arcomat.check.facts.Duplicates;
import arcomat.check.law.Check;
import arcomat.symbols.bodies.AutomatonSymbol;
import arcomat.symbols.expressions.ValueSymbol;

import java.util.List;

/** ARC0212: an automaton declares no variable, no input and no output twice. */
public final class VariableDeclaredOnce implements Check.OnAutomaton {

    @Override
    public void check(AutomatonSymbol automaton, Context context, Findings findings) {
        check(automaton.declaredPorts(), findings);
        check(automaton.variables(), findings);
    }

    private static void check(List<? extends ValueSymbol> values, Findings findings) {
        Duplicates.<ValueSymbol>report(
                values,
                ValueSymbol::name,
                (value, first) ->
                        findings.report(
                                        value.nameSpan(),
                                        "%s is declared twice; remove or rename one",
                                        Items.words(value))
                                .related(first.nameSpan(), "first declared here"));
    }
}
