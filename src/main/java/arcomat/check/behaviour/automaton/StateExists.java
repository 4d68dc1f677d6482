package arcomat.check.behaviour.automaton;

import arcomat.check.facts.StateNames;
import arcomat.check.law.Check;
import arcomat.source.Fix;
import arcomat.source.Fix.TextEdit;
import arcomat.source.Nearest;
import arcomat.symbols.bodies.AutomatonSymbol;
import arcomat.tree.Name;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;

/** ARC0304: initial states, sources and targets are declared states (Wor16 AR3). */
public final class StateExists implements Check.OnAutomaton {

    /** One finding per unknown name; an automaton without any state has a finding already. */
    @Override
    public void check(AutomatonSymbol automaton, Context context, Findings findings) {
        Set<String> declared = StateNames.declared(automaton);
        if (declared.isEmpty()) {
            return;
        }
        Map<String, List<Name>> unknown = new LinkedHashMap<>();
        for (Name use : StateNames.uses(automaton)) {
            if (!declared.contains(use.text())) {
                unknown.computeIfAbsent(use.text(), text -> new ArrayList<>()).add(use);
            }
        }
        unknown.values().forEach(uses -> report(uses, declared, findings));
    }

    private static void report(List<Name> uses, Set<String> declared, Findings findings) {
        Name first = uses.get(0);
        Optional<String> nearest = Nearest.to(first.text(), declared);
        findings.report(
                first,
                "there is no state '"
                        + first
                        + "'; "
                        + nearest.map(name -> "did you mean '" + name + "'?")
                                .orElse("declare it with 'state " + first + ";'"));
        for (Name use : uses.subList(1, uses.size())) {
            findings.related(use, "also used here");
        }
        nearest.ifPresent(name -> findings.fix(replaceAll(uses, name)));
    }

    private static Fix replaceAll(List<Name> uses, String name) {
        List<TextEdit> edits = uses.stream().map(use -> new TextEdit(use.span(), name)).toList();
        return new Fix("Change to '" + name + "'", edits);
    }
}
