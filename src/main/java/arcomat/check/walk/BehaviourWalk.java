package arcomat.check.walk;

import arcomat.check.law.Carrier;
import arcomat.check.law.Check;
import arcomat.check.law.Context;
import arcomat.check.walk.Listeners.Listener;
import arcomat.symbols.bodies.AutomatonSymbol;
import arcomat.symbols.bodies.InitialSymbol;
import arcomat.symbols.bodies.ItemSymbol;
import arcomat.symbols.bodies.ItemSymbol.Side;
import arcomat.symbols.bodies.StateSymbol;
import arcomat.symbols.bodies.TableSymbol;
import arcomat.symbols.bodies.TransitionSymbol;
import arcomat.symbols.expressions.ItemValue;
import arcomat.symbols.expressions.PortSymbol;
import arcomat.symbols.expressions.VariableSymbol;
import arcomat.tree.AutomatonElement;
import arcomat.tree.AutomatonElement.Declaration;
import arcomat.tree.Block;

import java.util.List;

/** The part of the walk that goes through automata and tables. */
final class BehaviourWalk {
    private final Listeners listeners;
    private final StereotypeWalk stereotypes;
    private final ExpressionWalk expressions;

    BehaviourWalk(Listeners listeners, StereotypeWalk stereotypes, ExpressionWalk expressions) {
        this.listeners = listeners;
        this.stereotypes = stereotypes;
        this.expressions = expressions;
    }

    void automaton(AutomatonSymbol automaton, Context around) {
        Context context = around.in(automaton);
        stereotypes.visit(
                automaton.node().stereotypes(), Carrier.AUTOMATON, automaton.node(), context);
        for (Listener<Check.OnAutomaton> each : listeners.onAutomaton) {
            each.check().check(automaton, context, each.findings());
        }
        declarations(automaton, context);
        for (StateSymbol state : automaton.states()) {
            state(state, context);
        }
        initials(automaton, context);
        for (TransitionSymbol transition : automaton.transitions()) {
            transition(transition, context);
        }
    }

    private void declarations(AutomatonSymbol automaton, Context context) {
        for (Declaration declaration : automaton.node().elements(Declaration.class)) {
            expressions.type(declaration.type(), context);
        }
        for (PortSymbol port : automaton.declaredPorts()) {
            for (Listener<Check.OnPort> each : listeners.onPort) {
                each.check().check(port, context, each.findings());
            }
        }
        for (VariableSymbol variable : automaton.variables()) {
            expressions.variable(variable, context);
        }
    }

    private void state(StateSymbol state, Context context) {
        stereotypes.visit(state.node().stereotypes(), Carrier.STATE, state.node(), context);
        for (Listener<Check.OnState> each : listeners.onState) {
            each.check().check(state, context, each.findings());
        }
    }

    /** A clause that names several states has one block for all of them. */
    private void initials(AutomatonSymbol automaton, Context context) {
        AutomatonElement.Initial last = null;
        for (InitialSymbol symbol : automaton.initials()) {
            AutomatonElement.Initial initial = symbol.node();
            if (initial != last) {
                for (Listener<Check.OnInitial> each : listeners.onInitial) {
                    each.check().check(initial, context, each.findings());
                }
                if (initial.output().isPresent()) {
                    block(initial.output().get(), symbol.items(), context.in(Side.INITIAL));
                }
            }
            last = initial;
        }
    }

    private void transition(TransitionSymbol transition, Context around) {
        Context context = around.in(transition);
        for (Listener<Check.OnTransition> each : listeners.onTransition) {
            each.check().check(transition, context, each.findings());
        }
        expressions.optional(transition.guard(), context);
        if (transition.node().input().isPresent()) {
            block(transition.node().input().get(), transition.input(), context.in(Side.INPUT));
        }
        if (transition.node().output().isPresent()) {
            block(transition.node().output().get(), transition.output(), context.in(Side.OUTPUT));
        }
    }

    private void block(Block block, List<ItemSymbol> items, Context context) {
        for (Listener<Check.OnBlock> each : listeners.onBlock) {
            each.check().check(block, items, context, each.findings());
        }
        for (ItemSymbol item : items) {
            for (Listener<Check.OnItem> each : listeners.onItem) {
                each.check().check(item, context, each.findings());
            }
            expressions.all(item.value().expressions(), context);
        }
    }

    void table(TableSymbol table, Context context) {
        stereotypes.visit(table.node().stereotypes(), Carrier.TABLE, table.node(), context);
        for (Listener<Check.OnTable> each : listeners.onTable) {
            each.check().check(table, context, each.findings());
        }
        for (TableSymbol.Row row : table.rows()) {
            cells(row.inputs(), context.in(Side.INPUT));
            cells(row.outputs(), context.in(Side.OUTPUT));
        }
    }

    private void cells(List<ItemValue> cells, Context context) {
        for (ItemValue cell : cells) {
            expressions.all(cell.expressions(), context);
        }
    }
}
