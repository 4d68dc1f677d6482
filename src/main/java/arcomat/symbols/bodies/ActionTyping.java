package arcomat.symbols.bodies;

import arcomat.symbols.bodies.ActionSymbol.Local;
import arcomat.symbols.bodies.ItemSymbol.Side;
import arcomat.symbols.expressions.ExpressionTyping;
import arcomat.symbols.expressions.ValueSymbol;
import arcomat.symbols.expressions.VariableSymbol;
import arcomat.symbols.names.BuiltinType;
import arcomat.symbols.names.Resolution;
import arcomat.symbols.names.TypeSymbol;
import arcomat.tree.Statement;
import arcomat.tree.Variable;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;

/** Says what the names in statements mean. What is declared is known to the end of its braces. */
final class ActionTyping implements Statement.Cases<ActionSymbol> {
    private final Side side;
    private ItemScope scope;

    ActionTyping(ItemScope scope, Side side) {
        this.scope = scope;
        this.side = side;
    }

    @Override
    public ActionSymbol.Sequence sequence(Statement.Sequence sequence) {
        ItemScope around = scope;
        List<ActionSymbol> actions = new ArrayList<>();
        for (Statement each : sequence.statements()) {
            actions.add(each.match(this));
        }
        scope = around;
        return new ActionSymbol.Sequence(sequence, actions);
    }

    @Override
    public ActionSymbol assignment(Statement.Assignment assignment) {
        return new ActionSymbol.Assign(assignment, scope.item(assignment.message(), side));
    }

    @Override
    public ActionSymbol choice(Statement.Choice choice) {
        return new ActionSymbol.Choose(
                choice,
                ExpressionTyping.type(choice.condition(), scope.values(), BuiltinType.BOOLEAN),
                branch(choice.then()),
                choice.otherwise().map(this::branch));
    }

    /** A declaration without braces is known to nobody. */
    private ActionSymbol branch(Statement branch) {
        ItemScope around = scope;
        ActionSymbol action = branch.match(this);
        scope = around;
        return action;
    }

    @Override
    public ActionSymbol locals(Statement.Locals locals) {
        Resolution<TypeSymbol> type = scope.values().type(locals.type());
        List<Local> symbols = new ArrayList<>();
        for (Variable each : locals.variables()) {
            Optional<ValueSymbol> hidden = scope.values().value(each.name().text());
            VariableSymbol symbol =
                    new VariableSymbol(
                            VariableSymbol.Kind.LOCAL,
                            each,
                            type,
                            ExpressionTyping.at(scope.values()));
            symbols.add(new Local(symbol, hidden));
            scope = scope.with(symbol);
        }
        return new ActionSymbol.Declare(locals, symbols);
    }
}
