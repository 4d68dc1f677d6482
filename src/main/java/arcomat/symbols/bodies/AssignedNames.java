package arcomat.symbols.bodies;

import arcomat.tree.Automaton;
import arcomat.tree.AutomatonElement;
import arcomat.tree.Block;

import java.util.HashSet;
import java.util.List;
import java.util.Optional;
import java.util.Set;

/** The names to which an automaton gives values, whatever they stand for. */
final class AssignedNames {
    private final Set<String> names = new HashSet<>();

    private AssignedNames() {}

    /** Of all output blocks; where a name is left out nothing is written that has to be named. */
    static Set<String> in(Automaton automaton) {
        AssignedNames written = new AssignedNames();
        for (var initial : automaton.elements(AutomatonElement.Initial.class)) {
            written.add(initial.output());
        }
        for (var transition : automaton.elements(AutomatonElement.Transition.class)) {
            written.add(transition.output());
        }
        return written.names;
    }

    private void add(Optional<Block> block) {
        for (Block.Item item : block.map(Block::items).orElse(List.of())) {
            if (item instanceof Block.Message message) {
                message.name().ifPresent(name -> names.add(name.text()));
            }
        }
    }
}
