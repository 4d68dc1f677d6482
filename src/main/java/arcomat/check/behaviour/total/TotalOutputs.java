package arcomat.check.behaviour.total;

import arcomat.check.behaviour.item.Items;
import arcomat.symbols.bodies.AutomatonSymbol;
import arcomat.symbols.bodies.AutomatonSymbol.InitialSymbol;
import arcomat.symbols.bodies.ComponentSymbol;
import arcomat.symbols.bodies.TransitionSymbol;
import arcomat.symbols.expressions.PortSymbol;

import java.util.List;
import java.util.Set;
import java.util.stream.Collectors;
import java.util.stream.Stream;

/** Which outputs with {@code <<total>>} a behaviour answers for. */
final class TotalOutputs {
    private TotalOutputs() {}

    /**
     * A sole automaton on an atomic component answers for all of them; otherwise an automaton
     * answers for those that it writes anywhere.
     */
    static List<PortSymbol> of(AutomatonSymbol automaton) {
        List<PortSymbol> all = totalOutputs(automaton.ports());
        if (all.isEmpty() || Items.isEventDriven(automaton) || ownsAllPorts(automaton)) {
            return Items.isEventDriven(automaton) ? List.of() : all;
        }
        Set<String> written = written(automaton);
        return all.stream().filter(port -> written.contains(port.name())).toList();
    }

    static List<PortSymbol> of(ComponentSymbol component) {
        return component.isEventDriven() ? List.of() : totalOutputs(component.ports());
    }

    private static List<PortSymbol> totalOutputs(List<PortSymbol> ports) {
        return ports.stream().filter(port -> port.isOutput() && port.isTotal()).toList();
    }

    private static boolean ownsAllPorts(AutomatonSymbol automaton) {
        return automaton.component().isEmpty()
                || !Items.isRequirement(automaton)
                        && automaton.component().get().ownAutomata().size() == 1;
    }

    private static Set<String> written(AutomatonSymbol automaton) {
        return Stream.concat(
                        automaton.initials().stream().map(InitialSymbol::items),
                        automaton.transitions().stream().map(TransitionSymbol::output))
                .flatMap(List::stream)
                .flatMap(item -> Items.port(item).stream())
                .map(PortSymbol::name)
                .collect(Collectors.toSet());
    }
}
