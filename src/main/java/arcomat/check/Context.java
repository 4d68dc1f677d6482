package arcomat.check;

import arcomat.symbols.Workspace;
import arcomat.tree.Automaton;
import arcomat.tree.AutomatonElement;
import arcomat.tree.Component;
import arcomat.tree.Unit;

import java.util.Optional;

/**
 * Where the walk is.
 *
 * @param component the innermost component around the node; empty in other files
 * @param automaton the automaton around the node
 * @param transition the transition around the node
 * @param side the side of the block around the node
 */
record Context(
        Workspace workspace,
        Unit unit,
        Optional<Component> component,
        Optional<Automaton> automaton,
        Optional<AutomatonElement.Transition> transition,
        Optional<BlockSide> side) {

    static Context of(Workspace workspace, Unit unit) {
        return new Context(
                workspace,
                unit,
                Optional.empty(),
                Optional.empty(),
                Optional.empty(),
                Optional.empty());
    }

    Context in(Component inner) {
        return new Context(
                workspace,
                unit,
                Optional.of(inner),
                Optional.empty(),
                Optional.empty(),
                Optional.empty());
    }

    Context in(Automaton inner) {
        return new Context(
                workspace,
                unit,
                component,
                Optional.of(inner),
                Optional.empty(),
                Optional.empty());
    }

    Context in(AutomatonElement.Transition inner) {
        return new Context(
                workspace, unit, component, automaton, Optional.of(inner), Optional.empty());
    }

    Context in(BlockSide inner) {
        return new Context(workspace, unit, component, automaton, transition, Optional.of(inner));
    }
}
