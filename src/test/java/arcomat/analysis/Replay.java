package arcomat.analysis;

import static org.assertj.core.api.Assertions.assertThat;

import arcomat.model.Component;
import arcomat.model.Letter;
import arcomat.model.Port;
import arcomat.model.Value;
import arcomat.semantics.Behaviour;
import arcomat.semantics.Behaviour.JointReaction;
import arcomat.semantics.Behaviour.JointStart;
import arcomat.semantics.Behaviour.Prospect;
import arcomat.semantics.Configuration;
import arcomat.semantics.Input;
import arcomat.semantics.Output;
import arcomat.semantics.Sent;

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
        if (canReplay(left)) {
            assertThat(possible(left, trace))
                    .as("%s can do it", left.title())
                    .isEqualTo(trace.size());
        }
        if (canReplay(right)) {
            int last =
                    right.each().stream()
                            .mapToInt(each -> possible(each, trace))
                            .min()
                            .orElseThrow();
            assertThat(last)
                    .as("%s forbids the last step only", right.title())
                    .isEqualTo(trace.size() - 1);
        }
    }

    private static boolean canReplay(Promise side) {
        return !side.isComposition()
                || side.component().profile() == Component.Profile.EVENT_DRIVEN;
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
    static int possible(Promise side, List<Moment> trace) {
        if (side.isComposition()) {
            return simulated(side, trace);
        }
        Behaviour behaviour = side.behaviour();
        List<Port> outputs = behaviour.component().outputs();
        Set<List<Configuration>> current = new LinkedHashSet<>();
        for (JointStart start : behaviour.starts()) {
            if (allows(outputs, start.output(), trace.get(0))) {
                current.add(start.configurations());
            }
        }
        int moments = 0;
        while (!current.isEmpty() && ++moments < trace.size()) {
            current = after(behaviour, current, trace.get(moments));
        }
        return moments;
    }

    private static Set<List<Configuration>> after(
            Behaviour behaviour, Set<List<Configuration>> before, Moment moment) {
        if (isUnseenEvent(behaviour.component(), moment.input())) {
            Output silence =
                    new Output(
                            Collections.nCopies(
                                    behaviour.component().outputs().size(), Sent.SILENCE));
            return allows(behaviour.component().outputs(), silence, moment) ? before : Set.of();
        }
        Set<List<Configuration>> next = new LinkedHashSet<>();
        Input input = input(behaviour, moment.input());
        for (List<Configuration> each : before) {
            Prospect prospect = behaviour.prospect(each, input);
            if (moment.error() && !prospect.errors().isEmpty()) {
                next.add(List.of(Configuration.ERROR));
            }
            for (JointReaction reaction : prospect.reactions()) {
                if (!moment.error()
                        && allows(behaviour.component().outputs(), reaction.output(), moment)) {
                    next.add(reaction.next());
                }
            }
        }
        return next;
    }

    private static Input input(Behaviour behaviour, Letter letter) {
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

    /** Whoever does not have the port of an event stands still. */
    private static boolean isUnseenEvent(Component component, Letter event) {
        return component.profile() == Component.Profile.EVENT_DRIVEN
                && component.inputs().stream()
                        .filter(port -> !port.latched())
                        .noneMatch(port -> event.message(port.name()).isPresent());
    }
}
