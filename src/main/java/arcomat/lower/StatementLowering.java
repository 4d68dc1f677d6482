package arcomat.lower;

import arcomat.model.Expression;
import arcomat.model.Port;
import arcomat.model.Statement;
import arcomat.model.Variable;
import arcomat.symbols.bodies.ActionSymbol;
import arcomat.symbols.bodies.ItemSymbol;
import arcomat.symbols.expressions.PortSymbol;
import arcomat.symbols.expressions.ValueSymbol;
import arcomat.symbols.expressions.VariableSymbol;

import java.util.ArrayList;
import java.util.List;
import java.util.Objects;
import java.util.Optional;

/** Statements as statements of the model, in their order. */
final class StatementLowering implements ActionSymbol.Cases<Statement> {
    private final Environment environment;

    private StatementLowering(Environment environment) {
        this.environment = environment;
    }

    /**
     * The statements.
     *
     * @param environment what the automaton can name
     */
    static Statement lower(ActionSymbol actions, Environment environment) {
        return actions.match(new StatementLowering(environment));
    }

    @Override
    public Statement sequence(ActionSymbol.Sequence sequence) {
        Environment known = environment;
        List<Statement> statements = new ArrayList<>();
        for (ActionSymbol each : sequence.actions()) {
            if (each instanceof ActionSymbol.Declare declare) {
                List<Variable> locals = variables(declare, known);
                locals.forEach(local -> statements.add(new Statement.Declare(local)));
                known = known.withVariables(locals);
            } else {
                statements.add(each.match(new StatementLowering(known)));
            }
        }
        return new Statement.Sequence(statements);
    }

    @Override
    public Statement assign(ActionSymbol.Assign assign) {
        ItemSymbol item = assign.item();
        ValueSymbol target = Lowering.resolved(item.target(), item.node().span());
        ExpressionLowering expressions = new ExpressionLowering(environment);
        if (target instanceof PortSymbol symbol) {
            Port port = Objects.requireNonNull(environment.ports().get(symbol.name()));
            return new Statement.Send(new ValueLowering(expressions).send(port, item.value()));
        }
        Variable variable = expressions.variable((VariableSymbol) target);
        return new Statement.Assign(
                variable, expressions.lower(item.value().expressions().get(0), variable.type()));
    }

    @Override
    public Statement choose(ActionSymbol.Choose choice) {
        Expression condition =
                new ExpressionLowering(environment).lower(choice.condition().expression());
        Optional<Statement> otherwise = choice.otherwise().map(each -> each.match(this));
        return new Statement.Choose(
                condition,
                choice.then().match(this),
                otherwise.orElse(new Statement.Sequence(List.of())));
    }

    @Override
    public Statement declare(ActionSymbol.Declare declare) {
        return new Statement.Sequence(
                variables(declare, environment).stream()
                        .<Statement>map(Statement.Declare::new)
                        .toList());
    }

    /** Each may be computed from those before it. */
    private static List<Variable> variables(ActionSymbol.Declare declare, Environment environment) {
        List<Variable> variables = new ArrayList<>();
        for (ActionSymbol.Local local : declare.locals()) {
            Environment known = environment.withVariables(variables);
            variables.addAll(VariableLowering.lower(List.of(local.variable()), known));
        }
        return variables;
    }
}
