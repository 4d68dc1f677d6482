package arcomat.check.facts;

import arcomat.source.Fix;
import arcomat.source.Fix.TextEdit;
import arcomat.symbols.bodies.AutomatonSymbol;
import arcomat.symbols.bodies.AutomatonSymbol.StateSymbol;
import arcomat.tree.AutomatonElement;
import arcomat.tree.AutomatonElement.Initial;
import arcomat.tree.AutomatonElement.Transition;
import arcomat.tree.Name;

import java.util.ArrayList;
import java.util.List;
import java.util.Set;
import java.util.stream.Collectors;
import java.util.stream.Stream;

/** The states of an automaton by their names: where they are declared and where they are used. */
public final class StateNames {
    private StateNames() {}

    public static Set<String> declared(AutomatonSymbol automaton) {
        return automaton.states().stream().map(StateSymbol::name).collect(Collectors.toSet());
    }

    /** Every mention of a state besides its declaration, in text order. */
    public static List<Name> uses(AutomatonSymbol automaton) {
        List<Name> uses = new ArrayList<>();
        for (AutomatonElement element : automaton.node().elements()) {
            if (element instanceof Initial initial) {
                uses.addAll(initial.states());
            } else if (element instanceof Transition transition) {
                uses.add(transition.source());
                transition.target().ifPresent(uses::add);
            }
        }
        return uses;
    }

    /** The edits that rename a state wherever the automaton mentions it. */
    public static Fix rename(AutomatonSymbol automaton, String from, String to) {
        List<TextEdit> edits =
                Stream.concat(
                                automaton.states().stream().map(state -> state.node().name()),
                                uses(automaton).stream())
                        .filter(name -> name.text().equals(from))
                        .map(name -> new TextEdit(name.span(), to))
                        .toList();
        return new Fix("Rename '" + from + "' to '" + to + "'", edits);
    }
}
