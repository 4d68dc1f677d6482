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
import arcomat.model.Variable;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.function.Function;
import java.util.function.Predicate;
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

    /** What is done before the first slice: each output is set, to a message or to none. */
    Effect ofInitial(ExpressionWriter text, List<Send> sends, List<Assignment> assignments) {
        return effect(text, sends, assignments, this::silence);
    }

    /**
     * What a transition does; outputs of which it says nothing are silent, see {@link #silences}.
     */
    Effect ofTransition(ExpressionWriter text, List<Send> sends, List<Assignment> assignments) {
        return effect(text, sends, assignments, port -> List.of());
    }

    /**
     * What comes before anything else in a slice: outputs that it may leave without a message have
     * none. Said once and not in each transition, the code is shorter, and a processor has one way
     * less to foresee for each of them.
     *
     * @param transitions that may be taken
     * @param completes whether there may be none
     */
    List<AssignmentView> silences(List<Automaton.Transition> transitions, boolean completes) {
        if (context.isEventDriven()) {
            return List.of();
        }
        Predicate<Port> mayBeSilent =
                port ->
                        completes && !isSentByCompletion(port)
                                || transitions.stream().anyMatch(t -> !isSent(port, t.sends()));
        return outputs.stream()
                .filter(mayBeSilent)
                .flatMap(port -> silence(port).stream())
                .toList();
    }

    private Effect effect(
            ExpressionWriter text,
            List<Send> sends,
            List<Assignment> assignments,
            Function<Port, List<AssignmentView>> unsent) {
        if (context.isEventDriven()) {
            return events(text, sends, assignments);
        }
        List<FieldView> locals = new ArrayList<>();
        boolean sendsFirst = text.checks().areNeeded(sends);
        List<AssignmentView> updates = updates(text, assignments, locals, sendsFirst, false);
        List<AssignmentView> all = new ArrayList<>();
        for (Port port : outputs) {
            List<String> messages = messages(text, port, sends);
            all.addAll(messages.isEmpty() ? unsent.apply(port) : sent(port, messages.get(0)));
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
        Optional<Send> send = on(port, sends);
        if (send.isPresent() && send.get().emission() instanceof Automaton.Messages messages) {
            return messages.values().stream()
                    .map(value -> text.inRange(value, port.type(), port.name()).text())
                    .toList();
        }
        return isSent(port, sends) ? List.of(anything(port)) : List.of();
    }

    private static Optional<Send> on(Port port, List<Send> sends) {
        return sends.stream().filter(send -> send.port().name().equals(port.name())).findFirst();
    }

    private boolean isSent(Port port, List<Send> sends) {
        boolean omitted = port.total() && automaton.omitted() == Automaton.Omitted.FREE;
        return on(port, sends)
                .map(Send::emission)
                .map(e -> e.match(m -> !m.values().isEmpty(), () -> false, () -> true))
                .orElse(omitted);
    }

    private boolean isSentByCompletion(Port port) {
        return port.total() && automaton.completion() != Automaton.Completion.IGNORE;
    }

    private String anything(Port port) {
        return context.expressions().of(port.type().first(), port.type()).text();
    }

    /** What is sent where no transition is enabled and no error is asked for. */
    List<AssignmentView> completion() {
        return context.isEventDriven()
                ? List.of()
                : outputs.stream()
                        .filter(this::isSentByCompletion)
                        .flatMap(port -> sent(port, anything(port)).stream())
                        .toList();
    }

    /** What a port carries, in the profile of slices. */
    List<AssignmentView> emitted(ExpressionWriter text, Port port, Automaton.Emission emission) {
        List<String> messages = messages(text, port, List.of(new Send(port, emission)));
        return messages.isEmpty() ? silence(port) : sent(port, messages.get(0));
    }

    /** Calls of the method that sends, in the profile of events. */
    List<AssignmentView> calls(ExpressionWriter text, Port port, Automaton.Emission emission) {
        return messages(text, port, List.of(new Send(port, emission))).stream()
                .map(value -> new AssignmentView(members.method(port), value))
                .toList();
    }

    private List<AssignmentView> sent(Port port, String message) {
        ExpressionWriter text = context.expressions();
        List<AssignmentView> fields = new ArrayList<>();
        fields.add(new AssignmentView(text.of(port).text(), message));
        if (!members.flag(port).isEmpty()) {
            fields.add(new AssignmentView(text.flag(port).text(), text.truth(true)));
        }
        return fields;
    }

    private List<AssignmentView> silence(Port port) {
        ExpressionWriter text = context.expressions();
        List<AssignmentView> fields = new ArrayList<>();
        if (port.type() instanceof Type.EnumType) {
            String silence = text.express("silence", port.type()).text();
            fields.add(new AssignmentView(text.of(port).text(), silence));
        }
        if (!members.flag(port).isEmpty()) {
            fields.add(new AssignmentView(text.flag(port).text(), text.truth(false)));
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
