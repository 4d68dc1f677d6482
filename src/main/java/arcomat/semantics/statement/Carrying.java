package arcomat.semantics.statement;

import static arcomat.semantics.expression.Formulas.FALSE;
import static arcomat.semantics.expression.Formulas.TRUE;
import static arcomat.semantics.expression.Formulas.and;
import static arcomat.semantics.expression.Formulas.not;
import static arcomat.semantics.expression.Formulas.or;

import arcomat.model.Automaton;
import arcomat.model.Component;
import arcomat.model.Expression;
import arcomat.model.Port;
import arcomat.model.Statement;
import arcomat.model.Type;
import arcomat.model.Value;
import arcomat.model.Variable;
import arcomat.semantics.expression.Interval;
import arcomat.semantics.expression.Presence;

import java.util.ArrayList;
import java.util.HashSet;
import java.util.LinkedHashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.stream.Collectors;

/**
 * Turns statements into steps, one after the other. A value that may go wrong or may be missing
 * stays an expression, since a later statement may overwrite it; so it does behind the choice that
 * decides whether it counts. All other values are computed at their places.
 */
final class Carrying {
    private static final Type BOOLEAN = new Type.BooleanType();

    private final Component component;
    private final boolean late;
    private final boolean aside;
    private final boolean counts;
    private final Automaton automaton;
    private final Presence presence;
    private final Cells cells;
    private final Map<String, Step.Declare> locals = new LinkedHashMap<>();
    private final Set<String> hoisted = new HashSet<>();
    private final Set<String> written = new HashSet<>();
    private final Set<String> loose = new HashSet<>();
    private int choices;
    private int saves;
    private boolean takesBack;

    /**
     * @param late whether messages are sent at the end
     * @param aside whether variables change at the end
     * @param counts whether the number of the way is counted
     */
    Carrying(
            Component component, Automaton automaton, boolean late, boolean aside, boolean counts) {
        this.component = component;
        this.automaton = automaton;
        this.late = late;
        this.aside = aside;
        this.counts = counts;
        this.presence = new Presence(component.profile());
        this.cells = new Cells(automaton, aside);
    }

    /** Whether something is done before it comes out that nothing is to be done. */
    boolean mayTakeBack() {
        return takesBack;
    }

    Procedure procedure(Automaton.Body body) {
        Statement statement = body.statement();
        List<Variable> kept =
                statement.assigned().stream().filter(each -> cells.isOwn(each.name())).toList();
        if (aside) {
            kept.forEach(each -> declare(cells.of(each), read(each)));
        }
        List<Step> steps = new ArrayList<>();
        Place place = Place.beginning(asked(body));
        Set<String> sure = SurelyRead.of(statement, automaton, presence);
        component.inputs().stream()
                .filter(port -> sure.contains(port.name()))
                .filter(port -> !place.present().contains(port.name()))
                .forEach(port -> need(carries(port), place, steps));
        place.learn(sure);
        carry(statement, place, steps, 1);
        finish(kept, place, steps);
        return finished(steps);
    }

    /** The ports that carry a message where the input block fits and the guard is true. */
    private Set<String> asked(Automaton.Body body) {
        Set<String> matched =
                body.matches().stream()
                        .filter(each -> !(each.pattern() instanceof Automaton.Absent))
                        .map(each -> each.port().name())
                        .collect(Collectors.toSet());
        return body.guard().map(guard -> presence.where(true, guard, matched)).orElse(matched);
    }

    private Expression carries(Port port) {
        return new Expression.PortMatches(port, new Automaton.Present(), automaton.span());
    }

    private Procedure finished(List<Step> steps) {
        Expression entry = TRUE;
        int first = 0;
        while (first < steps.size() && steps.get(first) instanceof Step.Need need) {
            entry = and(entry, need.condition());
            first++;
        }
        List<Step> rest = Hoisting.of(steps.subList(first, steps.size()), hoisted);
        cells.all().stream()
                .filter(cell -> hoisted.contains(cell.name()))
                .filter(cell -> Hoisting.changes(rest, cell.name()))
                .forEach(cell -> declare(cell, nothing(cell)));
        return new Procedure(entry, List.copyOf(locals.values()), rest);
    }

    private void declare(Variable cell, Expression value) {
        locals.putIfAbsent(cell.name(), new Step.Declare(cell, value));
    }

    private static Expression nothing(Variable cell) {
        return new Expression.Constant(cell.type().first(), cell.type(), cell.span());
    }

    private void carry(Statement statement, Place place, List<Step> steps, long weight) {
        statement.match(new Next(place, steps, weight));
    }

    /** The next statement. */
    private final class Next implements Statement.Cases<Void> {
        private final Place place;
        private final List<Step> steps;
        private final long weight;

        /**
         * @param weight how many ways there are behind it
         */
        Next(Place place, List<Step> steps, long weight) {
            this.place = place;
            this.steps = steps;
            this.weight = weight;
        }

        @Override
        public Void sequence(Statement.Sequence sequence) {
            List<String> here = new ArrayList<>();
            long behind = counts ? weight * sequence.ways() : 1;
            for (Statement each : sequence.statements()) {
                behind = counts ? behind / each.ways() : 1;
                carry(each, place, steps, behind);
                if (each instanceof Statement.Declare declare) {
                    here.add(declare.local().name());
                }
            }
            place.forget(here);
            here.stream()
                    .map(name -> cells.of(name).name())
                    .filter(place::needs)
                    .forEach(hoisted::add);
            return null;
        }

        @Override
        public Void declare(Statement.Declare declare) {
            Variable local = declare.local();
            Expression value = current(local.initial(), place);
            Expression present = present(local.initial(), place);
            Variable cell = cells.declared(local);
            if (isSafe(value, present)) {
                save(cell.name(), local.name(), place, steps);
                steps.add(new Step.Declare(cell, value));
                place.put(local, HeldValue.CELL);
            } else {
                hoisted.add(cell.name());
                place.put(local, HeldValue.Later.of(value, present));
            }
            return null;
        }

        @Override
        public Void assign(Statement.Assign assign) {
            Expression value = current(assign.value(), place);
            Expression present = present(assign.value(), place);
            Variable variable = assign.variable();
            if (isSafe(value, present)) {
                save(cells.of(variable).name(), variable.name(), place, steps);
                steps.add(new Step.Set(cells.of(variable), value));
                note(variable, value);
                place.put(variable, HeldValue.CELL);
            } else {
                place.put(variable, HeldValue.Later.of(value, present));
            }
            return null;
        }

        private void note(Variable variable, Expression value) {
            if (cells.isOwn(variable.name())) {
                written.add(variable.name());
                if (!fits(value, variable.type())) {
                    loose.add(variable.name());
                }
                if (!aside) {
                    place.setDone();
                }
            }
        }

        @Override
        public Void send(Statement.Send send) {
            Port port = send.send().port();
            Automaton.Emission emission = current(send.send().emission(), place);
            Expression present = TRUE;
            for (Expression value : send.send().emission().values()) {
                present = and(present, present(value, place));
            }
            Expression all = presence.simplify(present, Set.of());
            boolean now =
                    !late
                            && emission.values().stream()
                                    .allMatch(each -> isSafe(each, all) && fits(each, port.type()));
            if (now) {
                steps.add(new Step.Emit(port, emission));
                place.setDone();
            }
            place.putPort(port.name(), now ? HeldValue.CELL : new HeldValue.Later(emission, all));
            return null;
        }

        @Override
        public Void choose(Statement.Choose choose) {
            Expression condition = current(choose.condition(), place);
            if (condition instanceof Expression.Constant constant) {
                boolean truth = constant.value().equals(new Value.BooleanValue(true));
                carry(truth ? choose.then() : choose.otherwise(), place, steps, weight);
                return null;
            }
            if (!presence.isDefined(condition, place.present()) && presence.isStrict(condition)) {
                need(presence.present(condition, place.present()), place, steps);
                place.learn(presence.open(condition, place.present()));
            }
            branch(choose, condition);
            return null;
        }

        private void branch(Statement.Choose choose, Expression condition) {
            Variable chosen = new Variable("chosen " + ++choices, BOOLEAN, FALSE, condition.span());
            Place first = place.copy(presence.where(true, condition, place.present()));
            Place second = place.copy(presence.where(false, condition, place.present()));
            List<Step> then = new ArrayList<>();
            List<Step> otherwise = new ArrayList<>();
            carry(choose.then(), first, then, weight);
            if (counts) {
                otherwise.add(new Step.Count((int) (choose.then().ways() * weight)));
            }
            carry(choose.otherwise(), second, otherwise, weight);
            Set<String> present = place.present();
            boolean doneBefore = place.done();
            if (place.join(first, second, chosen)) {
                Carrying.this.declare(chosen, FALSE);
                then.add(0, new Step.Set(chosen, TRUE));
            }
            if (presence.isDefined(condition, present)) {
                steps.add(new Step.Choose(condition, then, otherwise));
                return;
            }
            takesBack |= doneBefore;
            List<Step> unlessNot =
                    List.of(
                            new Step.Choose(
                                    presence.certainly(false, condition, present),
                                    otherwise,
                                    List.of(new Step.Need(FALSE))));
            steps.add(
                    new Step.Choose(presence.certainly(true, condition, present), then, unlessNot));
        }
    }

    private void need(Expression condition, Place place, List<Step> steps) {
        Step need = new Step.Need(condition);
        if (!condition.equals(TRUE) && !steps.contains(need)) {
            steps.add(need);
            takesBack |= place.done();
        }
    }

    /** Keeps what stands in a cell for those that need it, before something else comes there. */
    private void save(String cell, String but, Place place, List<Step> steps) {
        if (place.needs(cell, but)) {
            Variable now = cells.called(cell);
            Variable saved =
                    new Variable("saved " + ++saves, now.type(), now.initial(), now.span());
            declare(saved, nothing(saved));
            steps.add(new Step.Set(saved, new Expression.VariableRead(now, now.span())));
            place.replace(cell, new Expression.VariableRead(saved, saved.span()));
        }
    }

    /** What is known of all that is kept and sent: whether it is there, then what it is. */
    private void finish(List<Variable> kept, Place place, List<Step> steps) {
        for (Variable each : kept) {
            demand(place.variable(each.name()), place, steps);
        }
        for (Port port : component.outputs()) {
            demand(place.port(port.name()), place, steps);
        }
        for (Variable each : kept) {
            HeldValue meaning = place.variable(each.name());
            if (meaning.equals(HeldValue.CELL)) {
                steps.addAll(keep(each, meaning));
                continue;
            }
            save(cells.of(each).name(), each.name(), place, steps);
            steps.addAll(keep(each, place.variable(each.name())));
            place.put(each, HeldValue.CELL);
        }
        for (Port port : component.outputs()) {
            steps.addAll(emit(port, place.port(port.name())));
        }
        if (aside) {
            for (Variable each : kept) {
                Variable field = Cells.wide(each, each.name());
                steps.add(new Step.Set(field, read(cells.of(each))));
            }
        }
    }

    private void demand(HeldValue meaning, Place place, List<Step> steps) {
        Expression present = presence.simplify(present(meaning), place.present());
        need(present, place, steps);
        place.learn(presence.where(true, present, place.present()));
    }

    /** That there is what an expression reads, by itself or through names. */
    private Expression present(Expression expression, Place place) {
        Set<String> names = new LinkedHashSet<>();
        expression.visit(
                e -> {
                    if (e instanceof Expression.VariableRead read) {
                        names.add(read.variable().name());
                    }
                });
        Expression all = presence.present(expression, place.present());
        for (String name : names) {
            all = and(all, present(place.variable(name)));
        }
        return presence.simplify(all, place.present());
    }

    private static Expression present(HeldValue meaning) {
        if (meaning instanceof HeldValue.Later later) {
            return later.present();
        }
        if (meaning instanceof HeldValue.Either either) {
            Expression then = present(either.then());
            Expression otherwise = present(either.otherwise());
            Expression chosen = read(either.chosen());
            return then.equals(otherwise)
                    ? then
                    : or(and(chosen, then), and(not(chosen), otherwise));
        }
        return TRUE;
    }

    private List<Step> keep(Variable variable, HeldValue meaning) {
        if (meaning instanceof HeldValue.Either either) {
            return List.of(
                    new Step.Choose(
                            read(either.chosen()),
                            keep(variable, either.then()),
                            keep(variable, either.otherwise())));
        }
        Variable cell = cells.of(variable);
        if (meaning instanceof HeldValue.Later later) {
            return List.of(keep(cell, later.value(), variable));
        }
        return loose.contains(variable.name())
                ? List.of(keep(cell, read(cell), variable))
                : List.of();
    }

    private static Step keep(Variable cell, Expression value, Variable variable) {
        return fits(value, variable.type())
                ? new Step.Set(cell, value)
                : new Step.Keep(cell, value, variable.type(), variable.name());
    }

    private static List<Step> emit(Port port, HeldValue meaning) {
        if (meaning instanceof HeldValue.Either either) {
            return List.of(
                    new Step.Choose(
                            read(either.chosen()),
                            emit(port, either.then()),
                            emit(port, either.otherwise())));
        }
        if (meaning instanceof HeldValue.Later later) {
            return List.of(new Step.Emit(port, later.emission()));
        }
        return List.of();
    }

    private static boolean isSafe(Expression value, Expression present) {
        return present.equals(TRUE) && !Presence.mayFail(value);
    }

    /** Whether a value is in the range of what it is for, whatever is read. */
    private static boolean fits(Expression value, Type wanted) {
        return Interval.fits(value, wanted, Interval::ofType);
    }

    private static Expression read(Variable variable) {
        return new Expression.VariableRead(variable, variable.span());
    }

    private Automaton.Emission current(Automaton.Emission emission, Place place) {
        return emission instanceof Automaton.Messages messages
                ? new Automaton.Messages(
                        messages.values().stream().map(value -> current(value, place)).toList())
                : emission;
    }

    /** An expression, said of what stands in cells. */
    private Expression current(Expression expression, Place place) {
        if (expression instanceof Expression.VariableRead variable) {
            String name = variable.variable().name();
            boolean constant = !cells.isOwn(name) && !cells.has(name);
            return constant ? variable : current(variable, place.variable(name));
        }
        return expression.withOperands(each -> current(each, place));
    }

    private Expression current(Expression.VariableRead read, HeldValue meaning) {
        if (meaning instanceof HeldValue.Later later) {
            return later.value();
        }
        if (meaning instanceof HeldValue.Either either) {
            return new Expression.Conditional(
                    read(either.chosen()),
                    current(read, either.then()),
                    current(read, either.otherwise()),
                    read.type(),
                    read.span());
        }
        String name = read.variable().name();
        return cells.isOwn(name) && !written.contains(name)
                ? read
                : new Expression.VariableRead(cells.of(read.variable()), read.span());
    }
}
