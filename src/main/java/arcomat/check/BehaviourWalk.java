package arcomat.check;

import arcomat.check.Listeners.Listener;
import arcomat.tree.Automaton;
import arcomat.tree.AutomatonElement;
import arcomat.tree.Block;
import arcomat.tree.IoTable;
import arcomat.tree.Node;
import arcomat.tree.Stereotype;
import arcomat.tree.Variable;

import java.util.List;

/** The part of the walk that goes through automata and tables. */
final class BehaviourWalk {
    private final Listeners listeners;
    private final Suppressions suppressions;
    private final ExpressionWalk expressions;

    BehaviourWalk(Listeners listeners, Suppressions suppressions, ExpressionWalk expressions) {
        this.listeners = listeners;
        this.suppressions = suppressions;
        this.expressions = expressions;
    }

    void automaton(Automaton automaton, Context around) {
        Context context = around.in(automaton);
        stereotypes(automaton.stereotypes(), Carrier.AUTOMATON, automaton, context);
        for (Listener<Check.OnAutomaton> each : listeners.onAutomaton) {
            each.check().check(automaton, context, each.findings());
        }
        for (AutomatonElement element : automaton.elements()) {
            element(element, context);
        }
    }

    private void element(AutomatonElement element, Context context) {
        if (element instanceof AutomatonElement.Transition transition) {
            transition(transition, context);
        } else if (element instanceof AutomatonElement.States states) {
            for (AutomatonElement.State state : states.states()) {
                state(state, context);
            }
        } else if (element instanceof AutomatonElement.Initial initial) {
            initial(initial, context);
        } else if (element instanceof AutomatonElement.Declaration declaration) {
            expressions.type(declaration.type(), context);
            for (Variable variable : declaration.variables()) {
                expressions.variable(variable, declaration.type(), context);
            }
        } else {
            throw new AssertionError(element);
        }
    }

    private void state(AutomatonElement.State state, Context context) {
        stereotypes(state.stereotypes(), Carrier.STATE, state, context);
        for (Listener<Check.OnState> each : listeners.onState) {
            each.check().check(state, context, each.findings());
        }
    }

    private void initial(AutomatonElement.Initial initial, Context context) {
        for (Listener<Check.OnInitial> each : listeners.onInitial) {
            each.check().check(initial, context, each.findings());
        }
        initial.output().ifPresent(block -> block(block, context.in(BlockSide.INITIAL)));
    }

    private void transition(AutomatonElement.Transition transition, Context around) {
        Context context = around.in(transition);
        for (Listener<Check.OnTransition> each : listeners.onTransition) {
            each.check().check(transition, context, each.findings());
        }
        transition.guard().ifPresent(guard -> expressions.one(guard.condition(), context));
        transition.input().ifPresent(block -> block(block, context.in(BlockSide.INPUT)));
        transition.output().ifPresent(block -> block(block, context.in(BlockSide.OUTPUT)));
    }

    private void block(Block block, Context context) {
        for (Listener<Check.OnBlock> each : listeners.onBlock) {
            each.check().check(block, context, each.findings());
        }
        for (Block.Item item : block.items()) {
            if (item instanceof Block.Message message) {
                expressions.value(message.value(), context);
            } else if (item instanceof Block.Call call) {
                expressions.one(call.expression(), context);
            }
        }
    }

    void table(IoTable table, Context context) {
        stereotypes(table.stereotypes(), Carrier.TABLE, table, context);
        for (Listener<Check.OnTable> each : listeners.onTable) {
            each.check().check(table, context, each.findings());
        }
        for (IoTable.Row row : table.rows()) {
            for (Block.Value value : row.inputs()) {
                expressions.value(value, context.in(BlockSide.INPUT));
            }
            for (Block.Value value : row.outputs()) {
                expressions.value(value, context.in(BlockSide.OUTPUT));
            }
        }
    }

    void stereotypes(
            List<Stereotype> stereotypes, Carrier carrier, Node owner, Context context) {
        if (stereotypes.isEmpty()) {
            return;
        }
        suppressions.add(stereotypes, owner);
        for (Listener<Check.OnStereotypes> each : listeners.onStereotypes) {
            each.check().check(stereotypes, carrier, owner, context, each.findings());
        }
    }
}
