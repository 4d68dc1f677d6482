package arcomat.generate;

import arcomat.generate.view.AssignmentView;
import arcomat.generate.view.FieldView;
import arcomat.model.Automaton;
import arcomat.model.Automaton.Assignment;
import arcomat.model.Automaton.Send;
import arcomat.model.Component;
import arcomat.model.Expression;
import arcomat.model.FirstValue;
import arcomat.model.Port;
import arcomat.model.Type;
import arcomat.model.Variable;

import java.util.ArrayList;
import java.util.List;

/**
 * The right-hand sides of a time-synchronous automaton as assignments to fields. All of them read
 * the values before the step; where one would overwrite what a later one reads, it goes through a
 * local variable.
 */
final class Effects {
    private final Component component;
    private final Automaton automaton;
    private final Members members;
    private final ExpressionText text;

    Effects(Component component, Automaton automaton, Members members, ExpressionText text) {
        this.component = component;
        this.automaton = automaton;
        this.members = members;
        this.text = text;
    }

    /** Locals first, then messages of the event-driven profile, then assignments, in order. */
    record Effect(
            List<FieldView> locals,
            List<AssignmentView> messages,
            List<AssignmentView> assignments) {}

    Effect of(List<Send> sends, List<Assignment> assignments) {
        if (component.profile() == Component.Profile.EVENT_DRIVEN) {
            return events(sends, assignments);
        }
        List<FieldView> locals = new ArrayList<>();
        List<AssignmentView> updates = updates(assignments, locals, mayFail(sends), false);
        List<AssignmentView> all = new ArrayList<>();
        for (Port port : component.outputs()) {
            all.addAll(send(port, sends));
        }
        all.addAll(updates);
        return new Effect(locals, List.of(), all);
    }

    /**
     * A message may change a latched port of the sender itself, and find a queue full: what may go
     * wrong or read that is computed before.
     */
    private Effect events(List<Send> sends, List<Assignment> assignments) {
        boolean latches = component.inputs().stream().anyMatch(Port::latched);
        List<FieldView> locals = new ArrayList<>();
        List<AssignmentView> updates = updates(assignments, locals, !sends.isEmpty(), latches);
        boolean before = latches || mayFail(sends);
        List<AssignmentView> messages = new ArrayList<>();
        for (Port port : component.outputs()) {
            for (String value : values(port, sends)) {
                String sent = value;
                if (before) {
                    sent = members.local("sent", port.name() + locals.size());
                    locals.add(new FieldView(text.type(port.type()), sent, value, ""));
                }
                messages.add(new AssignmentView(members.method(port), sent));
            }
        }
        return new Effect(locals, messages, updates);
    }

    /** What an event-driven automaton sends on a port, in order. */
    private List<String> values(Port port, List<Send> sends) {
        for (Send send : sends) {
            if (!send.port().name().equals(port.name())) {
                continue;
            }
            if (send.emission() instanceof Automaton.Messages messages) {
                return messages.values().stream()
                        .map(value -> text.inRange(value, port.type(), port.name()).text())
                        .toList();
            }
            boolean any = send.emission() instanceof Automaton.AnyMessage;
            return any ? List.of(firstValue(port)) : List.of();
        }
        boolean free = automaton.omitted() == Automaton.Omitted.FREE && port.total();
        return free ? List.of(firstValue(port)) : List.of();
    }

    private String firstValue(Port port) {
        return text.of(FirstValue.of(port.type()), port.type()).text();
    }

    /** What is sent where no transition is enabled and no error is asked for. */
    List<AssignmentView> completion() {
        List<AssignmentView> all = new ArrayList<>();
        if (component.profile() == Component.Profile.EVENT_DRIVEN) {
            return all;
        }
        boolean open = automaton.completion() != Automaton.Completion.IGNORE;
        for (Port port : component.outputs()) {
            all.addAll(open ? anything(port) : silence(port));
        }
        return all;
    }

    private List<AssignmentView> send(Port port, List<Send> sends) {
        for (Send send : sends) {
            if (send.port().name().equals(port.name())) {
                return send(port, send.emission());
            }
        }
        return automaton.omitted() == Automaton.Omitted.SILENT ? silence(port) : anything(port);
    }

    private List<AssignmentView> send(Port port, Automaton.Emission emission) {
        if (emission instanceof Automaton.Messages messages) {
            Expression value = messages.values().get(0);
            return message(port, text.inRange(value, port.type(), port.name()).text());
        }
        return emission instanceof Automaton.Silence ? silence(port) : first(port);
    }

    /** A run that draws nothing sends nothing, unless there has to be a message. */
    private List<AssignmentView> anything(Port port) {
        return port.total() ? first(port) : silence(port);
    }

    private List<AssignmentView> first(Port port) {
        return message(port, firstValue(port));
    }

    private List<AssignmentView> message(Port port, String value) {
        AssignmentView message = new AssignmentView(text.target(port), value);
        String flag = members.flag(port);
        return flag.isEmpty()
                ? List.of(message)
                : List.of(message, new AssignmentView(text.flagTarget(port), text.truth(true)));
    }

    private List<AssignmentView> silence(Port port) {
        if (port.type() instanceof Type.EnumType) {
            return List.of(new AssignmentView(text.target(port), text.silence(port).text()));
        }
        return members.flag(port).isEmpty()
                ? List.of()
                : List.of(new AssignmentView(text.flagTarget(port), text.truth(false)));
    }

    private List<AssignmentView> updates(
            List<Assignment> assignments, List<FieldView> locals, boolean first, boolean always) {
        List<AssignmentView> updates = new ArrayList<>();
        boolean mayFail = assignments.stream().anyMatch(a -> mayFail(a.value(), a));
        boolean overlaps = overlaps(assignments);
        boolean all = first && (always || mayFail) || overlaps && mayFail;
        for (int i = 0; i < assignments.size(); i++) {
            Assignment assignment = assignments.get(i);
            Variable variable = assignment.variable();
            String value =
                    text.inRange(assignment.value(), variable.type(), variable.name()).text();
            if (all || readsOneOf(assignment, assignments.subList(0, i))) {
                String local = members.local("next", variable.name());
                locals.add(new FieldView(text.type(variable.type()), local, value, ""));
                value = local;
            }
            updates.add(new AssignmentView(text.target(variable), value));
        }
        return updates;
    }

    private static boolean overlaps(List<Assignment> assignments) {
        for (int i = 1; i < assignments.size(); i++) {
            if (readsOneOf(assignments.get(i), assignments.subList(0, i))) {
                return true;
            }
        }
        return false;
    }

    /** Whether a value reads a variable that an earlier assignment has overwritten. */
    private static boolean readsOneOf(Assignment assignment, List<Assignment> earlier) {
        return earlier.stream().anyMatch(e -> reads(assignment.value(), e.variable()));
    }

    private static boolean reads(Expression expression, Variable variable) {
        return expression.contains(
                e ->
                        e instanceof Expression.VariableRead read
                                && read.variable().name().equals(variable.name()));
    }

    /** The interpreter computes variables before messages; the first error has to be the same. */
    private boolean mayFail(List<Send> sends) {
        for (Send send : sends) {
            if (send.emission() instanceof Automaton.Messages messages
                    && messages.values().stream()
                            .anyMatch(v -> text.mayFail(v, send.port().type()))) {
                return true;
            }
        }
        return false;
    }

    private boolean mayFail(Expression value, Assignment assignment) {
        return text.mayFail(value, assignment.variable().type());
    }
}
