package arcomat.semantics.statement;

import arcomat.model.Automaton;
import arcomat.model.Component;
import arcomat.model.Expression;
import arcomat.model.Port;
import arcomat.model.Type;
import arcomat.model.Value;
import arcomat.model.Variable;
import arcomat.semantics.expression.Effect;
import arcomat.semantics.expression.Evaluation;
import arcomat.semantics.expression.Fault;
import arcomat.semantics.expression.Output;
import arcomat.semantics.expression.Scope;
import arcomat.semantics.expression.Sent;
import arcomat.semantics.expression.Term;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;

/** Statements that are ready to be carried out: as one transition, whichever way is gone. */
public final class Carried {
    private final Term entry;
    private final List<Action> actions;
    private final Value[] nothing;
    private final int kept;
    private final List<Sent> unsent = new ArrayList<>();
    private final Scope scope;
    private final Map<String, Integer> outputs = new HashMap<>();

    /** What comes of it. */
    public record Result(Output output, Value[] variables) {}

    /** One step at a time, over what has been reached. */
    private interface Action {
        /** Whether it goes on. */
        boolean run(Run run);
    }

    /** Somebody's run. */
    private static final class Run {
        final Value[] ports;
        final Value[] variables;
        final List<Sent> sent;

        /** Whether it is being found out which way is gone, if any. */
        private boolean deciding = true;

        Run(Value[] ports, Value[] variables, List<Sent> sent) {
            this.ports = ports;
            this.variables = variables;
            this.sent = sent;
        }

        boolean decides(Term condition) {
            deciding = true;
            boolean holds = condition.holds(ports, variables);
            deciding = false;
            return holds;
        }
    }

    /**
     * @param owned names of the output ports that the automaton decides about
     * @param arguments one per parameter of the component
     */
    public Carried(
            Component component,
            Automaton automaton,
            Automaton.Body body,
            Set<String> owned,
            List<Value> arguments) {
        Procedure procedure =
                Procedure.of(component, automaton, body, Procedure.Form.AT_THE_END, false);
        List<Variable> locals = new ArrayList<>();
        procedure.locals().forEach(each -> locals.add(each.cell()));
        addDeclared(procedure.steps(), locals);
        this.kept = automaton.variables().size();
        this.scope = new Scope(component, arguments, automaton).with(locals);
        this.nothing = new Value[locals.size()];
        for (int i = 0; i < nothing.length; i++) {
            nothing[i] = locals.get(i).type().first();
        }
        List<Step> steps = new ArrayList<>(procedure.locals());
        steps.addAll(procedure.steps());
        for (Port port : component.outputs()) {
            outputs.put(port.name(), outputs.size());
            boolean silent = automaton.omitted() == Automaton.Omitted.SILENT;
            unsent.add(
                    owned.contains(port.name()) && silent ? Sent.SILENCE : Effect.anything(port));
        }
        this.entry = Evaluation.compile(procedure.entry(), scope);
        this.actions = actions(steps);
    }

    private static void addDeclared(List<Step> steps, List<Variable> locals) {
        for (Step each : steps) {
            if (each instanceof Step.Declare declare) {
                boolean known =
                        locals.stream().anyMatch(l -> l.name().equals(declare.cell().name()));
                if (!known) {
                    locals.add(declare.cell());
                }
            } else if (each instanceof Step.Choose choose) {
                addDeclared(choose.then(), locals);
                addDeclared(choose.otherwise(), locals);
            }
        }
    }

    /**
     * Whether a way is open.
     *
     * @throws Fault where a condition goes wrong
     */
    public boolean isOpen(Value[] ports, Value[] before) {
        Run run = run(ports, before);
        try {
            return run.decides(entry) && all(actions, run);
        } catch (Fault fault) {
            if (run.deciding) {
                throw fault;
            }
            return true;
        }
    }

    /**
     * What comes of them where a way is open.
     *
     * @throws Fault where something that is kept or sent goes wrong
     */
    public Result result(Value[] ports, Value[] before) {
        Run run = run(ports, before);
        all(actions, run);
        return new Result(new Output(run.sent), Arrays.copyOf(run.variables, kept));
    }

    private Run run(Value[] ports, Value[] before) {
        Value[] variables = Arrays.copyOf(before, kept + nothing.length);
        System.arraycopy(nothing, 0, variables, kept, nothing.length);
        return new Run(ports, variables, new ArrayList<>(unsent));
    }

    private static boolean all(List<Action> actions, Run run) {
        for (Action each : actions) {
            if (!each.run(run)) {
                return false;
            }
        }
        return true;
    }

    private List<Action> actions(List<Step> steps) {
        return steps.stream().map(each -> each.match(new Ready())).toList();
    }

    private Term term(Expression expression) {
        return Evaluation.compile(expression, scope);
    }

    /** Makes a step ready. */
    private final class Ready implements Step.Cases<Action> {
        @Override
        public Action declare(Step.Declare declare) {
            return assigned(declare.cell(), declare.value(), declare.cell().type(), "");
        }

        @Override
        public Action set(Step.Set set) {
            return assigned(set.cell(), set.value(), set.cell().type(), "");
        }

        @Override
        public Action keep(Step.Keep keep) {
            return assigned(keep.cell(), keep.value(), keep.wanted(), keep.name());
        }

        @SuppressWarnings("NullAway") // what is computed at its place has a value
        private Action assigned(Variable cell, Expression expression, Type wanted, String name) {
            int slot = scope.slot(cell);
            Term value = term(expression);
            return run -> {
                run.variables[slot] =
                        Effect.inRange(name, wanted, value.evaluate(run.ports, run.variables));
                return true;
            };
        }

        @Override
        @SuppressWarnings("NullAway") // what is computed at its place has a value
        public Action emit(Step.Emit emit) {
            Port port = emit.port();
            int place = outputs.get(port.name());
            if (emit.emission() instanceof Automaton.AnyMessage) {
                return run -> {
                    run.sent.set(place, new Sent.AnyMessage());
                    return true;
                };
            }
            List<Term> values = emit.emission().values().stream().map(Carried.this::term).toList();
            return run -> {
                List<Value> messages = new ArrayList<>(values.size());
                for (Term value : values) {
                    messages.add(
                            Effect.inRange(
                                    port.name(),
                                    port.type(),
                                    value.evaluate(run.ports, run.variables)));
                }
                run.sent.set(place, new Sent.Messages(messages));
                return true;
            };
        }

        @Override
        public Action choose(Step.Choose choose) {
            Term condition = term(choose.condition());
            List<Action> then = actions(choose.then());
            List<Action> otherwise = actions(choose.otherwise());
            return run -> all(run.decides(condition) ? then : otherwise, run);
        }

        @Override
        public Action need(Step.Need need) {
            Term condition = term(need.condition());
            return run -> run.decides(condition);
        }

        @Override
        public Action count(Step.Count count) {
            return run -> true;
        }
    }
}
