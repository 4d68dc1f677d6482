package montiarc7;

import montiarc7.grammar.MontiArc7Parser.AutomatonElementContext;
import montiarc7.grammar.MontiArc7Parser.ElementContext;
import montiarc7.grammar.MontiArc7Parser.PortDeclarationContext;
import montiarc7.grammar.MontiArc7Parser.PortsElementContext;
import montiarc7.grammar.MontiArc7Parser.UnitContext;
import montiarc7.source.Folder;
import montiarc7.source.Lacks;
import montiarc7.source.Placed;
import montiarc7.source.TypeNames;

import java.util.HashSet;
import java.util.LinkedHashMap;
import java.util.Map;
import java.util.Set;

/**
 * A component that a map may be about: its ports by direction with their full types, and its
 * states.
 */
final class MapSide {
    private final String path;
    private final String name;
    private final Map<String, String> inputs = new LinkedHashMap<>();
    private final Map<String, String> outputs = new LinkedHashMap<>();
    private final Set<String> states = new HashSet<>();
    private String initial = "";

    MapSide(String path, UnitContext unit, Folder folder, Lacks lacks) {
        this.path = path;
        this.name = unit.component().name(0).getText();
        TypeNames types = new TypeNames(unit, folder, lacks);
        types.enter(unit.component());
        for (Placed placed : Placed.of(unit.component().element())) {
            ElementContext element = placed.element();
            if (!placed.sides().isEmpty()) {
                continue;
            }
            if (element instanceof PortsElementContext ports) {
                ports.portDeclaration().forEach(each -> add(each, types));
            } else if (element instanceof AutomatonElementContext automaton) {
                Machine machine = new Machine(automaton.machineElement(), lacks);
                machine.resting().forEach(each -> states.add(each.name));
                initial =
                        machine.initial()
                                .map(Machine::beginning)
                                .map(each -> each.get(each.size() - 1).name)
                                .orElse("");
            }
        }
    }

    private void add(PortDeclarationContext ports, TypeNames types) {
        Map<String, String> side = ports.direction.getText().equals("in") ? inputs : outputs;
        ports.name().forEach(each -> side.put(each.getText(), types.full(ports.type())));
    }

    String path() {
        return path;
    }

    String name() {
        return name;
    }

    Map<String, String> inputs() {
        return inputs;
    }

    Map<String, String> outputs() {
        return outputs;
    }

    Set<String> states() {
        return states;
    }

    /** The state in which it is at the start. */
    String initial() {
        return initial;
    }

    boolean hasPort(String port) {
        return inputs.containsKey(port) || outputs.containsKey(port);
    }
}
