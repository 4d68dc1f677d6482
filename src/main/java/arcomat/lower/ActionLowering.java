package arcomat.lower;

import arcomat.model.Expression;
import arcomat.model.Port;
import arcomat.model.Value;
import arcomat.model.Variable;
import arcomat.symbols.bodies.ActionSymbol;
import arcomat.symbols.bodies.ItemSymbol;
import arcomat.symbols.expressions.PortSymbol;
import arcomat.symbols.expressions.ValueSymbol;
import arcomat.symbols.expressions.VariableSymbol;

import java.util.ArrayList;
import java.util.List;
import java.util.Objects;

/**
 * Statements as what happens at once. A name stands for what was assigned to it last, and each way
 * through the choices is one of its own.
 */
final class ActionLowering implements ActionSymbol.Cases<List<ActionPath>> {
    private final Environment environment;
    private final List<ActionPath> before;

    private ActionLowering(Environment environment, List<ActionPath> before) {
        this.environment = environment;
        this.before = before;
    }

    /**
     * @param environment what the automaton can name
     * @return the ways through the statements; the conditions of two of them exclude each other
     */
    static List<ActionPath> lower(ActionSymbol actions, Environment environment) {
        List<String> order = order(actions);
        return actions.match(new ActionLowering(environment, List.of(ActionPath.EMPTY))).stream()
                .map(path -> path.inOrder(order))
                .toList();
    }

    /** The names of what is assigned and sent, in the order in which the text says them first. */
    static List<String> order(ActionSymbol actions) {
        return actions.items().stream()
                .flatMap(item -> item.target().found().stream())
                .map(ValueSymbol::name)
                .distinct()
                .toList();
    }

    @Override
    public List<ActionPath> sequence(ActionSymbol.Sequence sequence) {
        Environment known = environment;
        List<ActionPath> paths = before;
        for (ActionSymbol each : sequence.actions()) {
            paths = each.match(new ActionLowering(known, paths));
            known =
                    each instanceof ActionSymbol.Declare declare
                            ? known.withVariables(variables(declare, known))
                            : known;
        }
        return paths;
    }

    @Override
    public List<ActionPath> assign(ActionSymbol.Assign assign) {
        ItemSymbol item = assign.item();
        ValueSymbol target = Lowering.resolved(item.target(), item.node().span());
        return before.stream()
                .map(
                        path ->
                                target instanceof PortSymbol port
                                        ? send(path, port, item)
                                        : assign(path, (VariableSymbol) target, item))
                .toList();
    }

    private ActionPath send(ActionPath path, PortSymbol symbol, ItemSymbol item) {
        Port port = Objects.requireNonNull(environment.ports().get(symbol.name()));
        ValueLowering values = new ValueLowering(new ExpressionLowering(environment));
        return path.sending(values.send(port, item.value()));
    }

    private ActionPath assign(ActionPath path, VariableSymbol symbol, ItemSymbol item) {
        ExpressionLowering expressions = new ExpressionLowering(environment);
        Variable variable = expressions.variable(symbol);
        return path.assigning(
                variable,
                expressions.lower(item.value().expressions().get(0), variable.type()),
                symbol.kind() == VariableSymbol.Kind.LOCAL);
    }

    @Override
    public List<ActionPath> choose(ActionSymbol.Choose choice) {
        Expression condition =
                new ExpressionLowering(environment).lower(choice.condition().expression());
        List<ActionPath> after = new ArrayList<>();
        for (ActionPath path : before) {
            Expression now = path.current(condition);
            if (!isConstant(now, false)) {
                after.addAll(choice.then().match(from(path.when(now))));
            }
            if (!isConstant(now, true)) {
                ActionPath otherwise =
                        isConstant(now, false) ? path : path.when(Connectives.not(now));
                after.addAll(
                        choice.otherwise()
                                .map(each -> each.match(from(otherwise)))
                                .orElse(List.of(otherwise)));
            }
        }
        return after;
    }

    private static boolean isConstant(Expression condition, boolean truth) {
        return condition instanceof Expression.Constant constant
                && constant.value().equals(new Value.BooleanValue(truth));
    }

    private ActionLowering from(ActionPath path) {
        return new ActionLowering(environment, List.of(path));
    }

    @Override
    public List<ActionPath> declare(ActionSymbol.Declare declare) {
        List<ActionPath> paths = before;
        for (Variable variable : variables(declare, environment)) {
            paths =
                    paths.stream()
                            .map(path -> path.assigning(variable, variable.initial(), true))
                            .toList();
        }
        return paths;
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
