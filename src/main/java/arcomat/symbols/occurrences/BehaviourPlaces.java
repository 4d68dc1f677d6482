package arcomat.symbols.occurrences;

import arcomat.symbols.bodies.ActionSymbol;
import arcomat.symbols.bodies.AutomatonSymbol;
import arcomat.symbols.bodies.AutomatonSymbol.InitialSymbol;
import arcomat.symbols.bodies.AutomatonSymbol.StateSymbol;
import arcomat.symbols.bodies.ItemSymbol;
import arcomat.symbols.bodies.ItemSymbol.Side;
import arcomat.symbols.bodies.TransitionSymbol;
import arcomat.symbols.expressions.ParameterSymbol;
import arcomat.symbols.expressions.PortSymbol;
import arcomat.symbols.expressions.Typed;
import arcomat.symbols.expressions.ValueSymbol;
import arcomat.symbols.expressions.VariableSymbol;
import arcomat.symbols.occurrences.Occurrence.Role;
import arcomat.tree.AutomatonElement;
import arcomat.tree.Name;

import java.util.Optional;

/** Names in automata. */
record BehaviourPlaces(NamePlaces places, ExpressionPlaces expressions) {

    void automaton(AutomatonSymbol automaton) {
        automaton
                .node()
                .name()
                .ifPresent(name -> places.declared(name.span(), new Referent.Behaviour(name)));
        for (var declaration : automaton.node().elements(AutomatonElement.Declaration.class)) {
            places.type(declaration.type(), expressions.types());
        }
        for (PortSymbol port : automaton.declaredPorts()) {
            places.declared(port.nameSpan(), new Referent.Port(port));
        }
        for (VariableSymbol variable : automaton.variables()) {
            places.declared(variable.nameSpan(), new Referent.Variable(variable));
            variable.initial().ifPresent(expressions::in);
        }
        for (StateSymbol state : automaton.states()) {
            places.declared(state.nameSpan(), new Referent.State(automaton, state));
        }
        initials(automaton);
        automaton.transitions().forEach(each -> transition(automaton, each));
    }

    /** A clause that names several states has one block for all of them. */
    private void initials(AutomatonSymbol automaton) {
        AutomatonElement.Initial last = null;
        for (InitialSymbol initial : automaton.initials()) {
            if (initial.node().declared().isEmpty()) {
                state(initial.name(), initial.state(), automaton);
            }
            if (initial.node() != last) {
                initial.items().forEach(this::item);
                initial.actions().ifPresent(this::actions);
            }
            last = initial.node();
        }
    }

    private void transition(AutomatonSymbol automaton, TransitionSymbol transition) {
        state(transition.node().source(), transition.source(), automaton);
        transition.node().target().ifPresent(name -> state(name, transition.target(), automaton));
        transition.guard().ifPresent(expressions::in);
        transition.input().forEach(this::item);
        transition.output().forEach(this::item);
        transition.actions().ifPresent(this::actions);
    }

    /** What is assigned is taken down with the items. */
    private void actions(ActionSymbol actions) {
        actions.choices().forEach(choice -> expressions.in(choice.condition()));
        for (ActionSymbol.Declare declared : actions.declarations()) {
            places.type(declared.node().type(), expressions.types());
            for (ActionSymbol.Local local : declared.locals()) {
                VariableSymbol variable = local.variable();
                places.declared(variable.nameSpan(), new Referent.Variable(variable));
                variable.initial().ifPresent(expressions::in);
            }
        }
    }

    private void state(Name name, Optional<StateSymbol> state, AutomatonSymbol automaton) {
        state.ifPresent(
                found ->
                        places.add(name.span(), new Referent.State(automaton, found), Role.REFERS));
    }

    private void item(ItemSymbol item) {
        Role role = item.side() == Side.INPUT ? Role.READS : Role.WRITES;
        item.node()
                .name()
                .ifPresent(
                        name ->
                                item.target()
                                        .found()
                                        .ifPresent(
                                                value ->
                                                        places.add(
                                                                name.span(),
                                                                referent(value),
                                                                role)));
        Optional<Name> name = item.node().name();
        for (Typed each : item.value().expressions()) {
            // In "n += 2" the name stands once, and is read and written.
            expressions.in(each, part -> name.isEmpty() || !part.span().equals(name.get().span()));
        }
    }

    private static Referent referent(ValueSymbol value) {
        if (value instanceof PortSymbol port) {
            return new Referent.Port(port);
        }
        return value instanceof VariableSymbol variable
                ? new Referent.Variable(variable)
                : new Referent.Parameter((ParameterSymbol) value);
    }
}
