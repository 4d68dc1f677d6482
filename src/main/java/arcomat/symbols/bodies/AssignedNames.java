package arcomat.symbols.bodies;

import arcomat.tree.Automaton;
import arcomat.tree.AutomatonElement;
import arcomat.tree.Block;
import arcomat.tree.Statement;

import java.util.HashSet;
import java.util.List;
import java.util.Optional;
import java.util.Set;

/** The names to which an automaton gives values, whatever they stand for. */
final class AssignedNames implements Statement.Cases<AssignedNames> {
    private final Set<String> names = new HashSet<>();

    private AssignedNames() {}

    /**
     * Of all output blocks and statements. Where a name is left out nothing is written that has to
     * be named.
     */
    static Set<String> in(Automaton automaton) {
        AssignedNames written = new AssignedNames();
        for (var initial : automaton.elements(AutomatonElement.Initial.class)) {
            written.add(initial.output());
            initial.actions().ifPresent(written::sequence);
        }
        for (var transition : automaton.elements(AutomatonElement.Transition.class)) {
            written.add(transition.output());
            transition.actions().ifPresent(written::sequence);
        }
        return written.names;
    }

    private void add(Optional<Block> block) {
        for (Block.Item item : block.map(Block::items).orElse(List.of())) {
            if (item instanceof Block.Message message) {
                add(message);
            }
        }
    }

    private void add(Block.Message message) {
        message.name().ifPresent(name -> names.add(name.text()));
    }

    @Override
    public AssignedNames sequence(Statement.Sequence sequence) {
        sequence.statements().forEach(each -> each.match(this));
        return this;
    }

    @Override
    public AssignedNames assignment(Statement.Assignment assignment) {
        add(assignment.message());
        return this;
    }

    @Override
    public AssignedNames choice(Statement.Choice choice) {
        choice.then().match(this);
        choice.otherwise().ifPresent(each -> each.match(this));
        return this;
    }

    @Override
    public AssignedNames locals(Statement.Locals locals) {
        return this;
    }
}
