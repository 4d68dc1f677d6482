package arcomat.pipeline.compile;

import arcomat.model.Component;
import arcomat.model.Letter;
import arcomat.model.Port;
import arcomat.model.Trace;
import arcomat.model.Value;
import arcomat.rt.Border;

import java.util.HashMap;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;

/** Shows an event-driven run to a generated monitor, as a program would. */
final class ShownEvents {
    private final Component watched;
    private final GeneratedMonitor monitor;
    private final List<PortSlot> inputs;
    private final JavaValues messages;
    private final Map<String, List<Value>> held = new HashMap<>();

    ShownEvents(
            Component watched,
            GeneratedMonitor monitor,
            List<PortSlot> inputs,
            JavaValues messages) {
        this.watched = watched;
        this.monitor = monitor;
        this.inputs = inputs;
        this.messages = messages;
    }

    void show(Trace run) {
        if (run.opening().isEmpty()) {
            run.end().ifPresent(end -> monitor.error());
            return;
        }
        Letter opening = run.opening().get();
        boolean kept = slice(Letter.SILENCE, opening);
        for (Trace.Step step : run.steps()) {
            Letter before = step.number() == 0 ? opening : Letter.SILENCE;
            boolean event =
                    step.inputs().messages().keySet().stream().anyMatch(p -> isEvent(run, p));
            latch(step.inputs());
            if (kept && event) {
                kept = slice(step.inputs(), behind(before, step.outputs()));
            }
        }
        if (kept && run.end().isPresent()) {
            latch(run.end().get().inputs());
            write(run.end().get().inputs());
            // what was sent before it went wrong is not looked at
            run.steps().stream()
                    .skip(Math.max(0, run.steps().size() - 1))
                    .forEach(step -> send(step.outputs()));
            monitor.error();
        }
    }

    private static boolean isEvent(Trace run, String port) {
        return run.component().port(port).map(p -> !p.latched()).orElse(true);
    }

    private void latch(Letter letter) {
        watched.inputs().stream()
                .filter(port -> port.latched() && !letter.messages(port.name()).isEmpty())
                .forEach(port -> held.put(port.name(), letter.messages(port.name())));
    }

    private void write(Letter letter) {
        Map<String, List<Value>> all = new LinkedHashMap<>(letter.messages());
        all.putAll(held);
        inputs.forEach(slot -> slot.write(new Letter(all)));
    }

    private boolean slice(Letter letter, Letter shown) {
        write(letter);
        send(shown);
        return monitor.slice();
    }

    private void send(Letter shown) {
        Border border = monitor.border();
        for (Port port : watched.outputs()) {
            for (Value value : shown.messages(port.name())) {
                send(border, port.name(), messages.toJava(value, port.type()));
            }
        }
    }

    /** As generated code does it: each kind of message has a method of its own. */
    private static void send(Border border, String port, Object message) {
        if (message instanceof Integer number) {
            border.sent(port, number.intValue());
        } else if (message instanceof Long number) {
            border.sent(port, number.longValue());
        } else if (message instanceof Boolean truth) {
            border.sent(port, truth.booleanValue());
        } else if (message instanceof Character character) {
            border.sent(port, character.charValue());
        } else if (message instanceof Number number) {
            border.sent(port, number.doubleValue());
        } else {
            border.sent(port, message);
        }
    }

    private static Letter behind(Letter opening, Letter shown) {
        Map<String, List<Value>> rest = new LinkedHashMap<>();
        shown.messages()
                .forEach(
                        (port, all) ->
                                rest.put(
                                        port,
                                        all.subList(opening.messages(port).size(), all.size())));
        return new Letter(rest);
    }
}
