package arcomat.check;

import arcomat.symbols.AutomatonSymbol;
import arcomat.symbols.ComponentSymbol;
import arcomat.tree.Name;

import java.util.HashMap;
import java.util.Map;

/** ARC0206: the automata of one component differ in name. */
final class AutomataNamesUnique implements Check.OnComponent {

    @Override
    public Law law() {
        return Law.error("ARC0206");
    }

    @Override
    public void check(ComponentSymbol component, Context context, Findings findings) {
        Map<String, Name> seen = new HashMap<>();
        for (AutomatonSymbol automaton : component.ownAutomata()) {
            automaton.node().name().ifPresent(name -> check(name, seen, component, findings));
        }
    }

    private static void check(
            Name name, Map<String, Name> seen, ComponentSymbol component, Findings findings) {
        Name first = seen.putIfAbsent(name.text(), name);
        if (first != null) {
            findings.report(
                            name,
                            "component '"
                                    + component.name()
                                    + "' has two automata named '"
                                    + name
                                    + "'; rename one")
                    .related(first, "the other one is declared here");
        }
    }
}
