package arcomat.analysis.refinement;

import arcomat.analysis.search.Moment;
import arcomat.model.Component;
import arcomat.model.Letter;
import arcomat.model.Port;
import arcomat.model.Trace;
import arcomat.model.Value;
import arcomat.semantics.expression.Sent;
import arcomat.semantics.network.Network;

import java.util.ArrayList;
import java.util.HashSet;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;

/**
 * The run of the left side in a counterexample, as somebody sees it who looks at the ports: each
 * message in the slice in which it is visible. What the counterexample leaves open is silent, or
 * the first value.
 */
public final class CounterexampleRun {
    private final Component right;
    private final Component left;
    private final List<Moment> moments;
    private final boolean events;

    /** Outputs of the left side that show a reaction one slice later. */
    private final Set<String> late;

    private CounterexampleRun(Component left, Component right, List<Moment> moments) {
        this.left = left;
        this.right = right;
        this.moments = moments;
        events = left.profile() == Component.Profile.EVENT_DRIVEN;
        late = events ? Set.of() : late(left);
    }

    public static Trace of(Component left, Component right, List<Moment> moments) {
        return new CounterexampleRun(left, right, moments).trace();
    }

    static Set<String> late(Component component) {
        Network network = Network.of(component, List.of());
        Set<Integer> delayed = network.delayed();
        Set<String> names = new HashSet<>();
        network.outputs().stream()
                .filter(each -> delayed.contains(each.signal()))
                .forEach(each -> names.add(each.name()));
        return names;
    }

    private Trace trace() {
        Moment last = moments.get(moments.size() - 1);
        List<Trace.Step> steps = new ArrayList<>();
        int slices = last.error() || events ? moments.size() - 1 : moments.size();
        for (int slice = 0; slice < slices; slice++) {
            boolean read = slice + 1 < moments.size();
            if (!read || !moments.get(slice + 1).error()) {
                Letter inputs = read ? moments.get(slice + 1).input() : silence();
                steps.add(new Trace.Step(slice, inputs, shown(slice, late), List.of()));
            }
        }
        Optional<String> failure = last.error() ? Optional.of("error") : Optional.empty();
        Optional<Letter> opening = Optional.empty();
        if (events && !moments.get(0).error()) {
            opening = Optional.of(outputs(moments.get(0)));
        }
        return new Trace(left, steps, failure, opening, end(last));
    }

    private Optional<Trace.End> end(Moment last) {
        if (!last.error()) {
            return Optional.empty();
        }
        Map<String, List<Value>> seen =
                new LinkedHashMap<>(shown(moments.size() - 2, late).messages());
        seen.keySet().retainAll(late);
        return Optional.of(new Trace.End(last.input(), new Letter(seen)));
    }

    private Letter shown(int slice, Set<String> late) {
        Map<String, List<Value>> shown = new LinkedHashMap<>();
        for (Port port : right.outputs()) {
            boolean seenLater = isPaired(port) && late.contains(port.name());
            int moment = seenLater ? slice : slice + 1;
            if (moment < moments.size()) {
                shown.put(port.name(), messages(moments.get(moment), port));
            }
        }
        if (events && slice == 0) {
            outputs(moments.get(0))
                    .messages()
                    .forEach((port, first) -> shown.merge(port, first, (r, f) -> joined(f, r)));
        }
        return new Letter(shown);
    }

    /** Where the sides have different delays, a moment shows the message in its slice. */
    private boolean isPaired(Port port) {
        return events || port.delay() == 1;
    }

    private static List<Value> joined(List<Value> first, List<Value> then) {
        List<Value> all = new ArrayList<>(first);
        all.addAll(then);
        return all;
    }

    /** No input is read any more; the slice only shows the last reaction. */
    private Letter silence() {
        Map<String, Value> totals = new LinkedHashMap<>();
        for (Port port : left.inputs()) {
            if (port.total()) {
                totals.put(port.name(), port.type().first());
            }
        }
        return Letter.of(totals);
    }

    private Letter outputs(Moment moment) {
        Map<String, List<Value>> messages = new LinkedHashMap<>();
        right.outputs().forEach(port -> messages.put(port.name(), messages(moment, port)));
        return new Letter(messages);
    }

    private static List<Value> messages(Moment moment, Port port) {
        Sent sent = moment.outputs().getOrDefault(port.name(), Sent.SILENCE);
        if (sent instanceof Sent.Messages certain) {
            return certain.values();
        }
        return sent.allows(List.of()) ? List.of() : List.of(port.type().first());
    }
}
