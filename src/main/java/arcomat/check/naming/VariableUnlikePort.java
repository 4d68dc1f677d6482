package arcomat.check.naming;

import arcomat.check.behaviour.item.Items;
import arcomat.check.law.Check;
import arcomat.symbols.bodies.AutomatonSymbol;
import arcomat.symbols.expressions.ValueSymbol;
import arcomat.symbols.expressions.VariableSymbol;

import java.util.HashMap;
import java.util.List;
import java.util.Map;

/** ARC0205: a variable of an automaton has a name of its own in its component. (Wor16 AU3) */
public final class VariableUnlikePort implements Check.OnAutomaton {

    @Override
    public void check(AutomatonSymbol automaton, Context context, Findings findings) {
        if (automaton.variables().isEmpty()) {
            return;
        }
        Map<String, ValueSymbol> others = new HashMap<>();
        addAll(automaton.ports(), others);
        automaton.component().ifPresent(component -> addAll(component.parameters(), others));
        automaton
                .component()
                .ifPresent(component -> addAll(component.signature().variables(), others));
        for (VariableSymbol variable : automaton.variables()) {
            ValueSymbol other = others.get(variable.name());
            if (other != null) {
                report(variable, other, findings);
            }
        }
    }

    private static void addAll(
            List<? extends ValueSymbol> values, Map<String, ValueSymbol> others) {
        values.forEach(value -> others.putIfAbsent(value.name(), value));
    }

    private static void report(VariableSymbol variable, ValueSymbol other, Findings findings) {
        findings.report(
                        variable.nameSpan(),
                        "variable '%s' is named like %s; rename the variable",
                        variable.name(),
                        Items.words(other))
                .related(other.nameSpan(), "declared here");
    }
}
