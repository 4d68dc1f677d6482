package arcomat.generate.views;

import arcomat.generate.text.ExpressionWriter;
import arcomat.generate.text.FileContext;
import arcomat.generate.text.MemberNames;
import arcomat.generate.view.HeadView.AssignmentView;
import arcomat.generate.view.HeadView.FieldView;
import arcomat.model.Automaton;
import arcomat.model.Automaton.Assignment;
import arcomat.model.Automaton.Send;
import arcomat.model.Expression;
import arcomat.model.Port;
import arcomat.model.Type;
import arcomat.model.Value;
import arcomat.model.Variable;

import java.util.ArrayList;
import java.util.List;
import java.util.stream.IntStream;

/**
 * The right-hand sides of an automaton as assignments to fields, or as messages where events drive
 * it. All of them read the values before the step; where one would overwrite what a later one
 * reads, it goes through a local variable.
 */
final class Effects {
    private final FileContext context;
    private final List<Port> outputs;
    private final Automaton automaton;
    private final MemberNames members;

    Effects(FileContext context, Automaton automaton) {
        this.context = context;
        this.outputs = context.component().outputs();
        this.automaton = automaton;
        this.members = context.members();
    }

    /** Locals first, then messages of the event-driven profile, then assignments, in order. */
    record Effect(
            List<FieldView> locals,
            List<AssignmentView> messages,
            List<AssignmentView> assignments) {}

    /**
     * What is done.
     *
     * @param text of the transition
     */
    Effect of(ExpressionWriter text, List<Send> sends, List<Assignment> assignments) {
        if (context.isEventDriven()) {
            return events(text, sends, assignments);
        }
        List<FieldView> locals = new ArrayList<>();
        boolean sendsFirst = text.checks().areNeeded(sends);
        List<AssignmentView> updates = updates(text, assignments, locals, sendsFirst, false);
        List<AssignmentView> all = new ArrayList<>();
        for (Port port : outputs) {
            all.addAll(shown(port, messages(text, port, sends)));
        }
        all.addAll(updates);
        return new Effect(locals, List.of(), all);
    }

    /**
     * A message may change a latched port of the sender itself, and find a queue full: what may go
     * wrong or read that is computed before.
     */
    private Effect events(ExpressionWriter text, List<Send> sends, List<Assignment> assignments) {
        boolean latches = context.component().inputs().stream().anyMatch(Port::latched);
        List<FieldView> locals = new ArrayList<>();
        List<AssignmentView> updates =
                updates(text, assignments, locals, !sends.isEmpty(), latches);
        boolean before = latches || text.checks().areNeeded(sends);
        List<AssignmentView> messages = new ArrayList<>();
        for (Port port : outputs) {
            for (String value : messages(text, port, sends)) {
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

    /**
     * What is sent on a port, in order. A run that draws nothing sends nothing, unless there has to
     * be a message.
     */
    private List<String> messages(ExpressionWriter text, Port port, List<Send> sends) {
        for (Send send : sends) {
            if (!send.port().name().equals(port.name())) {
                continue;
            }
            if (send.emission() instanceof Automaton.Messages messages) {
                return messages.values().stream()
                        .map(value -> text.inRange(value, port.type(), port.name()).text())
                        .toList();
            }
            return anything(port, send.emission() instanceof Automaton.AnyMessage);
        }
        return anything(port, port.total() && automaton.omitted() == Automaton.Omitted.FREE);
    }

    private List<String> anything(Port port, boolean something) {
        Value first = port.type().first();
        return something ? List.of(context.expressions().of(first, port.type()).text()) : List.of();
    }

    /** What is sent where no transition is enabled and no error is asked for. */
    List<AssignmentView> completion() {
        boolean open = automaton.completion() != Automaton.Completion.IGNORE;
        return context.isEventDriven()
                ? List.of()
                : outputs.stream()
                        .flatMap(port -> shown(port, anything(port, open && port.total())).stream())
                        .toList();
    }

    /** The fields of a port where it carries the message, or where there is none. */
    private List<AssignmentView> shown(Port port, List<String> messages) {
        ExpressionWriter text = context.expressions();
        String field = text.of(port).text();
        List<AssignmentView> fields = new ArrayList<>();
        if (!messages.isEmpty()) {
            fields.add(new AssignmentView(field, messages.get(0)));
        } else if (port.type() instanceof Type.EnumType) {
            fields.add(new AssignmentView(field, text.express("silence", port.type()).text()));
        }
        if (!members.flag(port).isEmpty()) {
            String present = text.truth(!messages.isEmpty());
            fields.add(new AssignmentView(text.flag(port).text(), present));
        }
        return fields;
    }

    /**
     * The variables.
     *
     * @param locals gets what has to be computed before
     * @param first whether something else comes before the assignments
     * @param always whether that could change what they read
     */
    private List<AssignmentView> updates(
            ExpressionWriter text,
            List<Assignment> assignments,
            List<FieldView> locals,
            boolean first,
            boolean always) {
        List<AssignmentView> updates = new ArrayList<>();
        boolean mayFail = text.checks().areNeededFor(assignments);
        boolean overlaps =
                IntStream.range(0, assignments.size()).anyMatch(i -> readsEarlier(assignments, i));
        boolean all = first && (always || mayFail) || overlaps && mayFail;
        for (int i = 0; i < assignments.size(); i++) {
            Variable variable = assignments.get(i).variable();
            String value =
                    text.inRange(assignments.get(i).value(), variable.type(), variable.name())
                            .text();
            if (all || readsEarlier(assignments, i)) {
                String local = members.local("next", variable.name());
                locals.add(new FieldView(text.type(variable.type()), local, value, ""));
                value = local;
            }
            updates.add(new AssignmentView(text.of(variable).text(), value));
        }
        return updates;
    }

    /** Whether a value reads a variable that an earlier assignment has overwritten. */
    private static boolean readsEarlier(List<Assignment> assignments, int index) {
        List<String> overwritten =
                assignments.subList(0, index).stream().map(a -> a.variable().name()).toList();
        return !overwritten.isEmpty()
                && assignments
                        .get(index)
                        .value()
                        .contains(
                                e ->
                                        e instanceof Expression.VariableRead read
                                                && overwritten.contains(read.variable().name()));
    }
}
