package arcomat.check;

import arcomat.symbols.AutomatonSymbol;
import arcomat.symbols.ValueSymbol;

import java.util.HashMap;
import java.util.List;
import java.util.Map;

/** ARC0212: an automaton declares no variable, no input and no output twice. */
final class VariableDeclaredOnce implements Check.OnAutomaton {

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
