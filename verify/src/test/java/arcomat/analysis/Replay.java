package arcomat.analysis;

import static org.assertj.core.api.Assertions.assertThat;

import arcomat.analysis.refinement.Verdict;
import arcomat.analysis.search.Moment;
import arcomat.model.Component;
import arcomat.model.Letter;
import arcomat.model.Port;
import arcomat.model.Value;
import arcomat.semantics.Promise;
import arcomat.semantics.automaton.ComponentSemantics;
import arcomat.semantics.automaton.ComponentSemantics.JointReaction;
import arcomat.semantics.automaton.ComponentSemantics.JointStart;
import arcomat.semantics.automaton.ComponentSemantics.Prospect;
import arcomat.semantics.automaton.Configuration;
import arcomat.semantics.automaton.Input;
import arcomat.semantics.expression.Output;
import arcomat.semantics.expression.Sent;
import arcomat.semantics.network.Network;

import java.util.ArrayList;
import java.util.Collections;
import java.util.LinkedHashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;

/**
 * Replays a counterexample outside the engine: the left side can do all of it, the right side all
 * but its last step. Nothing of the engine is used, only the step relation.
 */
public final class Replay {
    private Replay() {}

    public static void check(Promise left, Promise right, Verdict verdict) {
        List<Moment> trace = verdict.trace();
        if (canReplay(left, trace)) {
            assertThat(possible(left, trace, late(left, right)))
                    .as("%s can do it", left.title())
                    .isEqualTo(trace.size());
        }
        if (canReplay(right, trace)) {
            int last =
                    right.each().stream()
                            .mapToInt(each -> possible(each, trace, late(right, left)))
                            .min()
                            .orElseThrow();
            assertThat(last)
                    .as("%s forbids the last step only", right.title())
                    .isEqualTo(trace.size() - 1);
        }
    }

    /** Ports that only one side sends on with delay stand in the slice in which they are seen. */
    private static Set<String> late(Promise side, Promise other) {
        Set<String> late = new LinkedHashSet<>();
        if (side.component().profile() == Component.Profile.EVENT_DRIVEN) {
            return late;
        }
        side.component().outputs().stream()
                .map(Port::name)
                .filter(name -> delay(side, name) == 1 && delay(other, name) == 0)
                .forEach(late::add);
        return late;
    }

    private static int delay(Promise side, String port) {
        if (!side.isComposition()) {
            return side.component().port(port).map(Port::delay).orElse(-1);
        }
        Network network = Network.of(side.component(), side.arguments());
        return network.outputs().stream()
                .filter(each -> each.name().equals(port) && each.signal() >= 0)
                .map(each -> network.delayed().contains(each.signal()) ? 1 : 0)
                .findAny()
                .orElse(-1);
    }

    /** The simulator gives a composition no event that no port is there for. */
    private static boolean canReplay(Promise side, List<Moment> trace) {
        Component component = side.component();
        return !side.isComposition()
                || component.profile() == Component.Profile.EVENT_DRIVEN
                        && trace.stream()
                                .skip(1)
                                .noneMatch(each -> isUnseenEvent(component, each.input()));
    }

    /** How many moments a composition can follow, by the simulator. */
    private static int simulated(Promise side, List<Moment> trace) {
        List<Letter> letters = new ArrayList<>();
        for (Moment moment : trace.subList(1, trace.size())) {
            Map<String, List<Value>> own = new LinkedHashMap<>(moment.input().messages());
            own.keySet().removeIf(name -> side.component().port(name).isEmpty());
            letters.add(new Letter(own));
        }
        int most = 0;
        for (SimulatedRuns.Run run :
                SimulatedRuns.of(side.component(), side.arguments(), letters)) {
            int moments = 0;
            while (moments < run.outputs().size()
                    && shows(side, run.outputs().get(moments), trace.get(moments))) {
                moments++;
            }
            boolean ends = run.error() && moments == run.outputs().size();
            most = Math.max(most, moments + (ends && trace.get(moments).error() ? 1 : 0));
        }
        return most;
    }

    private static boolean shows(Promise side, Map<String, List<Value>> outputs, Moment moment) {
        return !moment.error()
                && side.component().outputs().stream()
                        .map(Port::name)
                        .filter(name -> moment.outputs().get(name) instanceof Sent.Messages)
                        .allMatch(
                                name ->
                                        moment.outputs()
                                                .get(name)
                                                .allows(outputs.getOrDefault(name, List.of())));
    }

    /** How many moments a side can follow; an error is a moment without outputs. */
    public static int possible(Promise side, List<Moment> trace) {
        return possible(side, trace, Set.of());
    }

    /**
     * Where an automaton may be.
     *
     * @param made what it has sent last
     */
    private record Place(List<Configuration> configurations, Output made) {}

    private static int possible(Promise side, List<Moment> trace, Set<String> late) {
        if (side.isComposition()) {
            return simulated(side, trace);
        }
        ComponentSemantics behaviour = side.behaviour();
        List<Port> outputs = behaviour.component().outputs();
        Output silence = new Output(Collections.nCopies(outputs.size(), Sent.SILENCE));
        Set<Place> current = new LinkedHashSet<>();
        for (JointStart start : behaviour.starts()) {
            if (allows(outputs, seen(outputs, start.output(), silence, late), trace.get(0))) {
                current.add(new Place(start.configurations(), start.output()));
            }
        }
        int moments = 0;
        while (!current.isEmpty() && ++moments < trace.size()) {
            current = after(behaviour, current, trace.get(moments), late);
        }
        return moments;
    }

    /** On late ports what was sent before. */
    private static Output seen(List<Port> ports, Output now, Output before, Set<String> late) {
        List<Sent> seen = new ArrayList<>();
        for (int i = 0; i < ports.size(); i++) {
            seen.add((late.contains(ports.get(i).name()) ? before : now).ports().get(i));
        }
        return new Output(seen);
    }

    private static Set<Place> after(
            ComponentSemantics behaviour, Set<Place> before, Moment moment, Set<String> late) {
        List<Port> ports = behaviour.component().outputs();
        Output silence = new Output(Collections.nCopies(ports.size(), Sent.SILENCE));
        Set<Place> next = new LinkedHashSet<>();
        Input input = input(behaviour, moment.input());
        for (Place each : before) {
            Prospect prospect = behaviour.prospect(each.configurations, input);
            if (moment.error()
                    && !prospect.errors().isEmpty()
                    && allows(ports, seen(ports, silence, each.made, late), moment)) {
                next.add(new Place(List.of(Configuration.ERROR), silence));
            }
            for (JointReaction reaction : prospect.reactions()) {
                Output seen = seen(ports, reaction.output(), each.made, late);
                if (!moment.error() && allows(ports, seen, moment)) {
                    next.add(new Place(reaction.next(), reaction.output()));
                }
            }
        }
        return next;
    }

    private static Input input(ComponentSemantics behaviour, Letter letter) {
        return Input.of(behaviour.component(), letter);
    }

    /** A port that the moment leaves open has to be open here too. */
    private static boolean allows(List<Port> ports, Output output, Moment moment) {
        Map<String, Sent> sent = moment.outputs();
        for (int i = 0; i < ports.size(); i++) {
            Sent said = sent.getOrDefault(ports.get(i).name(), Sent.SILENCE);
            Sent own = output.ports().get(i);
            boolean allowed =
                    said instanceof Sent.Messages messages
                            ? own.allows(messages.values())
                            : !(own instanceof Sent.Messages);
            if (!allowed) {
                return false;
            }
        }
        return true;
    }

    private static boolean isUnseenEvent(Component component, Letter event) {
        return component.inputs().stream()
                .filter(port -> !port.latched())
                .noneMatch(port -> event.message(port.name()).isPresent());
    }
}
