package arcomat.check.walk;

import arcomat.check.law.Carrier;
import arcomat.check.law.Check;
import arcomat.check.law.Check.Context;
import arcomat.check.walk.Listeners.Listener;
import arcomat.symbols.bodies.ActionSymbol;
import arcomat.symbols.bodies.AutomatonSymbol;
import arcomat.symbols.bodies.AutomatonSymbol.InitialSymbol;
import arcomat.symbols.bodies.AutomatonSymbol.StateSymbol;
import arcomat.symbols.bodies.ItemSymbol;
import arcomat.symbols.bodies.ItemSymbol.Side;
import arcomat.symbols.bodies.TransitionSymbol;
import arcomat.symbols.expressions.PortSymbol;
import arcomat.symbols.expressions.Typed;
import arcomat.symbols.expressions.VariableSymbol;
import arcomat.tree.AutomatonElement;
import arcomat.tree.AutomatonElement.Declaration;
import arcomat.tree.Block;

import java.util.List;

/** The part of the walk that goes through automata and tables. */
record BehaviourWalk(Listeners listeners, StereotypeWalk stereotypes, ExpressionWalk expressions) {

    void automaton(AutomatonSymbol automaton, Context around) {
        Context context = around.in(automaton);
        stereotypes.visit(
                automaton.node().stereotypes(), Carrier.AUTOMATON, automaton.node(), context);
        for (Listener<Check.OnAutomaton> each : listeners.onAutomaton) {
            each.check().check(automaton, context, each.findings());
        }
        declarations(automaton, context);
        for (StateSymbol state : automaton.states()) {
            stereotypes.visit(state.node().stereotypes(), Carrier.STATE, state.node(), context);
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

    /** A clause that names several states has one block for all of them. */
    private void initials(AutomatonSymbol automaton, Context context) {
        AutomatonElement.Initial last = null;
        for (InitialSymbol symbol : automaton.initials()) {
            AutomatonElement.Initial initial = symbol.node();
            if (initial != last && initial.output().isPresent()) {
                block(initial.output().get(), symbol.items(), context.in(Side.INITIAL));
            }
            if (initial != last && symbol.actions().isPresent()) {
                actions(symbol.actions().get(), context.in(Side.INITIAL));
            }
            last = initial;
        }
    }

    private void transition(TransitionSymbol transition, Context around) {
        Context context = around.in(transition);
        for (Listener<Check.OnTransition> each : listeners.onTransition) {
            each.check().check(transition, context, each.findings());
        }
        transition.guard().ifPresent(guard -> expressions.one(guard, context));
        if (transition.node().input().isPresent()) {
            block(transition.node().input().get(), transition.input(), context.in(Side.INPUT));
        }
        if (transition.node().output().isPresent()) {
            block(transition.node().output().get(), transition.output(), context.in(Side.OUTPUT));
        }
        if (transition.actions().isPresent()) {
            actions(transition.actions().get(), context.in(Side.OUTPUT));
        }
    }

    private void actions(ActionSymbol actions, Context context) {
        for (Listener<Check.OnActions> each : listeners.onActions) {
            each.check().check(actions, context, each.findings());
        }
        for (ActionSymbol.Declare declared : actions.declarations()) {
            expressions.type(declared.node().type(), context);
            for (ActionSymbol.Local local : declared.locals()) {
                expressions.variable(local.variable(), context);
            }
        }
        actions.choices().forEach(choice -> expressions.one(choice.condition(), context));
        actions.items().forEach(item -> item(item, context));
    }

    private void block(Block block, List<ItemSymbol> items, Context context) {
        for (Listener<Check.OnBlock> each : listeners.onBlock) {
            each.check().check(block, items, context, each.findings());
        }
        items.forEach(item -> item(item, context));
    }

    private void item(ItemSymbol item, Context context) {
        for (Listener<Check.OnItem> each : listeners.onItem) {
            each.check().check(item, context, each.findings());
        }
        List<Typed> values = item.value().expressions();
        item.target()
                .found()
                .ifPresentOrElse(
                        target -> expressions.values(values, target.type(), context),
                        () -> expressions.all(values, context));
    }
}
