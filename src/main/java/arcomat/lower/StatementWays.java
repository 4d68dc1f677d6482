package arcomat.lower;

import arcomat.model.Component;
import arcomat.model.Expression;
import arcomat.model.Statement;
import arcomat.model.Value;
import arcomat.model.Variable;

import org.jspecify.annotations.Nullable;

import java.util.ArrayList;
import java.util.HashSet;
import java.util.IdentityHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.function.UnaryOperator;

/**
 * Takes the ways through statements. All that a way does is said of the values before the first
 * statement: a name stands for what was assigned to it last. Ways that have been told apart by a
 * choice can become one again behind it, as far as one transition can say both.
 */
final class StatementWays implements Statement.Cases<List<JoinedPath>> {
    private final JoinedPath.Ports ports;
    private final Joining joining;
    private final List<JoinedPath> before;

    /**
     * How ways become one again.
     *
     * @param joins whether they do at all
     * @param most how many there may be at most
     */
    private record Joining(boolean joins, long most) {
        static final Joining NONE = new Joining(false, Long.MAX_VALUE);
    }

    private StatementWays(JoinedPath.Ports ports, Joining joining, List<JoinedPath> before) {
        this.ports = ports;
        this.joining = joining;
        this.before = before;
    }

    /** It takes more than is wanted. */
    private static final class TooMany extends RuntimeException {
        private static final long serialVersionUID = 1L;

        TooMany() {
            super("too many", null, false, false);
        }
    }

    /** Each way, whose conditions exclude those of the others. */
    static List<ActionPath> all(Statement statement, Component.Profile profile) {
        return paths(statement, profile, Joining.NONE);
    }

    /**
     * The same with few ways, where those that can be joined are.
     *
     * @param most how many there may be at most
     * @param largest of how many parts a value or a condition may be
     * @return nothing where there would be more, or larger ones
     */
    static Optional<List<ActionPath>> joined(
            Statement statement, Component.Profile profile, int most, long largest) {
        try {
            List<ActionPath> paths = paths(statement, profile, new Joining(true, most));
            Map<Expression, Long> sizes = new IdentityHashMap<>();
            boolean small =
                    paths.stream()
                            .flatMap(path -> path.expressions().stream())
                            .allMatch(each -> size(each, largest, sizes) <= largest);
            return small ? Optional.of(paths) : Optional.empty();
        } catch (TooMany tooMany) {
            return Optional.empty();
        }
    }

    private static List<ActionPath> paths(
            Statement statement, Component.Profile profile, Joining joining) {
        JoinedPath.Ports ports = new JoinedPath.Ports(profile);
        List<String> order = statement.assigned().stream().map(Variable::name).toList();
        return statement
                .match(new StatementWays(ports, joining, List.of(JoinedPath.EMPTY)))
                .stream()
                .map(way -> way.path().inOrder(order))
                .toList();
    }

    private static long size(Expression e, long largest, Map<Expression, Long> sizes) {
        Long known = sizes.get(e);
        if (known != null) {
            return known;
        }
        long size = 1;
        for (Expression operand : e.operands()) {
            size = Math.min(largest + 1, size + size(operand, largest, sizes));
        }
        sizes.put(e, size);
        return size;
    }

    private List<JoinedPath> each(UnaryOperator<ActionPath> change) {
        return before.stream().map(each -> each.with(change.apply(each.path()))).toList();
    }

    @Override
    public List<JoinedPath> sequence(Statement.Sequence sequence) {
        List<JoinedPath> paths = before;
        Set<Variable> here = new HashSet<>();
        for (Statement each : sequence.statements()) {
            paths = each.match(new StatementWays(ports, joining, paths));
            if (each instanceof Statement.Declare declare) {
                here.add(declare.local());
            }
        }
        return here.isEmpty() ? paths : paths.stream().map(each -> each.without(here)).toList();
    }

    @Override
    public List<JoinedPath> declare(Statement.Declare declare) {
        Variable local = declare.local();
        return each(path -> path.assigning(local, local.initial()));
    }

    @Override
    public List<JoinedPath> assign(Statement.Assign assign) {
        return each(path -> path.assigning(assign.variable(), assign.value()));
    }

    @Override
    public List<JoinedPath> send(Statement.Send send) {
        return each(path -> path.sending(send.send()));
    }

    @Override
    public List<JoinedPath> choose(Statement.Choose choose) {
        List<JoinedPath> after = new ArrayList<>();
        for (JoinedPath each : before) {
            after.addAll(choose(choose, each));
            if (after.size() > joining.most()) {
                throw new TooMany();
            }
        }
        return after;
    }

    private List<JoinedPath> choose(Statement.Choose choose, JoinedPath path) {
        Expression condition = path.path().current(choose.condition());
        if (condition instanceof Expression.Constant constant) {
            boolean truth = constant.value().equals(new Value.BooleanValue(true));
            return (truth ? choose.then() : choose.otherwise())
                    .match(new StatementWays(ports, joining, List.of(path)));
        }
        Expression contrary = Connectives.not(condition);
        boolean strict = isStrict(condition);
        JoinedPath start = path.unasked(strict ? ports.of(condition) : Set.of());
        List<JoinedPath> then = behind(choose.then(), start);
        List<JoinedPath> otherwise = new ArrayList<>(behind(choose.otherwise(), start));
        List<JoinedPath> after = new ArrayList<>();
        for (JoinedPath first : then) {
            JoinedPath joined =
                    strict && joining.joins() ? joined(condition, first, otherwise, path) : null;
            after.add(joined != null ? joined : first.behind(List.of(condition)));
        }
        otherwise.forEach(second -> after.add(second.behind(List.of(contrary))));
        List<Expression> asked = path.path().conditions();
        return after.stream().map(each -> each.behind(asked)).toList();
    }

    private List<JoinedPath> behind(Statement statement, JoinedPath start) {
        return statement.match(new StatementWays(ports, joining, List.of(start)));
    }

    /** With the first of others that it can be joined with, which is left out then. */
    private @Nullable JoinedPath joined(
            Expression condition, JoinedPath first, List<JoinedPath> others, JoinedPath path) {
        for (JoinedPath second : others) {
            Optional<ActionPath> both = first.join(condition, second, ports);
            if (both.isPresent()) {
                others.remove(second);
                Set<String> present = new HashSet<>(first.present());
                present.retainAll(second.present());
                return new JoinedPath(both.get(), present)
                        .behind(asked(condition, first.path(), second.path(), path));
            }
        }
        return null;
    }

    /** What is asked of one of two ways, and of the condition that it has a value. */
    private List<Expression> asked(
            Expression condition, ActionPath first, ActionPath second, JoinedPath path) {
        Expression contrary = Connectives.not(condition);
        boolean unasked = first.conditions().isEmpty() && second.conditions().isEmpty();
        if (unasked && path.present().containsAll(ports.of(condition)) && !condition.divides()) {
            return List.of();
        }
        List<Expression> then = new ArrayList<>(List.of(condition));
        then.addAll(first.conditions());
        List<Expression> otherwise = new ArrayList<>(List.of(contrary));
        otherwise.addAll(second.conditions());
        return List.of(
                Connectives.disjunction(
                        List.of(
                                Connectives.conjunction(then),
                                Connectives.conjunction(otherwise))));
    }

    /** Whether a condition has a value just where all ports that it reads carry a message. */
    private boolean isStrict(Expression condition) {
        return ports.of(condition).isEmpty()
                || !condition.contains(
                        e ->
                                e instanceof Expression.Conditional
                                        || e instanceof Expression.PortMatches
                                        || isLazy(e));
    }

    private static boolean isLazy(Expression e) {
        return e instanceof Expression.Binary binary && binary.operator().isLazy();
    }
}
