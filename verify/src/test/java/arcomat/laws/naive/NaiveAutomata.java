package arcomat.laws.naive;

import arcomat.laws.naive.NaiveValues.Wrong;
import arcomat.model.Automaton;
import arcomat.model.Automaton.Completion;
import arcomat.model.Automaton.Send;
import arcomat.model.Component;
import arcomat.model.Port;
import arcomat.model.Value;
import arcomat.model.Variable;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.IdentityHashMap;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;

/** The automata of one component: each step is one that all of them allow. */
final class NaiveAutomata {

    /**
     * Where one automaton is.
     *
     * @param state -1 in chaos
     */
    record Place(int state, Map<String, Value> variables) {
        static final Place CHAOS = new Place(-1, Map.of());
    }

    /** A step: what is said on each output, and where each automaton is afterwards. */
    record Step(Map<String, Slot> outputs, List<Place> places) {}

    /**
     * All that may happen.
     *
     * @param error whether the run may end in an error here
     */
    record Steps(List<Step> steps, boolean error) {}

    private final Component component;
    private final List<Automaton> automata;
    private final List<Port> outputs;
    private final Map<Automaton, Map<String, Boolean>> owned = new IdentityHashMap<>();

    NaiveAutomata(Component component, List<Automaton> automata) {
        this.component = component;
        this.automata = automata;
        this.outputs = component.outputs();
    }

    Component component() {
        return component;
    }

    private static boolean writes(Automaton automaton, Port port) {
        return automaton.initials().stream().anyMatch(i -> send(i.sends(), port).isPresent())
                || automaton.transitions().stream()
                        .anyMatch(t -> send(t.sends(), port).isPresent());
    }

    private static Optional<Send> send(List<Send> sends, Port port) {
        return sends.stream().filter(s -> s.port().name().equals(port.name())).findFirst();
    }

    /**
     * What nobody writes belongs to all, but not to a sole requirement on a composition; and nobody
     * says which messages a port carries that has one in every slice.
     */
    private boolean owns(Automaton automaton, Port port) {
        return owned.computeIfAbsent(automaton, each -> new HashMap<>())
                .computeIfAbsent(port.name(), each -> isOwned(automaton, port));
    }

    private boolean isOwned(Automaton automaton, Port port) {
        List<Automaton> all = component.automata();
        return writes(automaton, port)
                || !(component.isComposite() && all.size() == 1)
                        && !port.total()
                        && all.stream().noneMatch(other -> writes(other, port));
    }

    private boolean isTimed() {
        return component.profile() == Component.Profile.TIME_SYNCHRONOUS;
    }

    /** What has no delay is not sent yet; it is open here, and nobody looks at it. */
    List<Step> starts() {
        List<List<Step>> each = new ArrayList<>();
        for (Automaton automaton : automata) {
            List<Step> own = new ArrayList<>();
            Map<String, Value> variables = new HashMap<>();
            component.constants().forEach(constant -> put(constant, variables));
            automaton.variables().forEach(variable -> put(variable, variables));
            NaiveValues values = new NaiveValues(Map.of(), variables);
            for (Automaton.Initial initial : automaton.initials()) {
                Step step =
                        effect(
                                automaton,
                                initial.state(),
                                initial.sends(),
                                initial.assignments(),
                                values);
                outputs.stream()
                        .filter(port -> isTimed() && port.delay() == 0)
                        .forEach(port -> step.outputs.put(port.name(), Slot.open(port)));
                own.add(step);
            }
            each.add(own);
        }
        return joint(each);
    }

    private static void put(Variable variable, Map<String, Value> values) {
        NaiveValues known = new NaiveValues(Map.of(), Map.copyOf(values));
        values.put(variable.name(), known.of(variable.initial()));
    }

    Steps steps(List<Place> places, Map<String, Value> inputs, boolean unknownEvent) {
        List<List<Step>> each = new ArrayList<>();
        boolean error = true;
        for (int i = 0; i < automata.size(); i++) {
            Steps own = steps(automata.get(i), places.get(i), inputs, unknownEvent);
            each.add(own.steps);
            error &= own.error;
        }
        return new Steps(joint(each), error);
    }

    private Steps steps(
            Automaton automaton, Place place, Map<String, Value> inputs, boolean unknownEvent) {
        if (place.equals(Place.CHAOS)) {
            return new Steps(List.of(step(open(), Place.CHAOS)), false);
        }
        List<Step> steps = new ArrayList<>();
        boolean wrong = false;
        NaiveValues values = new NaiveValues(inputs, place.variables);
        for (Automaton.Transition each : automaton.transitions()) {
            try {
                boolean from = each.source() == place.state && !unknownEvent;
                if (from && isEnabled(each, values) && isFirst(automaton, each, values)) {
                    steps.add(
                            effect(
                                    automaton,
                                    each.target(),
                                    each.sends(),
                                    each.assignments(),
                                    values));
                }
            } catch (Wrong end) {
                wrong = true;
            }
        }
        if (steps.isEmpty() && !wrong) {
            return completed(automaton, place);
        }
        return new Steps(steps, wrong);
    }

    private Steps completed(Automaton automaton, Place place) {
        Completion completion = automaton.completion();
        if (completion == Completion.ERROR) {
            return new Steps(List.of(), true);
        }
        Map<String, Slot> said = open();
        if (completion == Completion.IGNORE) {
            outputs.stream()
                    .filter(p -> owns(automaton, p))
                    .forEach(p -> said.put(p.name(), Slot.SILENCE));
        }
        return new Steps(
                List.of(step(said, completion == Completion.CHAOS ? Place.CHAOS : place)), false);
    }

    private static Step step(Map<String, Slot> said, Place place) {
        return new Step(said, List.of(place));
    }

    private Map<String, Slot> open() {
        Map<String, Slot> open = new LinkedHashMap<>();
        outputs.forEach(port -> open.put(port.name(), Slot.open(port)));
        return open;
    }

    private static boolean isFirst(
            Automaton automaton, Automaton.Transition transition, NaiveValues values) {
        return automaton.transitions().stream()
                .filter(each -> each.source() == transition.source())
                .filter(each -> each.rank() < transition.rank())
                .noneMatch(each -> isEnabled(each, values));
    }

    private static boolean isEnabled(Automaton.Transition transition, NaiveValues values) {
        return transition.matches().stream()
                        .allMatch(m -> values.matches(m.port().name(), m.pattern()))
                && transition.guard().map(values::isTrue).orElse(true)
                && transition.sends().stream().allMatch(s -> isDefined(s, values))
                && transition.assignments().stream().allMatch(a -> values.isReadable(a.value()));
    }

    private static boolean isDefined(Send send, NaiveValues values) {
        return !(send.emission() instanceof Automaton.Messages messages)
                || messages.values().stream().allMatch(values::isReadable);
    }

    private Step effect(
            Automaton automaton,
            int target,
            List<Send> sends,
            List<Automaton.Assignment> assignments,
            NaiveValues values) {
        Map<String, Slot> said = new LinkedHashMap<>();
        for (Port port : outputs) {
            Slot omitted =
                    owns(automaton, port) && automaton.omitted() == Automaton.Omitted.SILENT
                            ? Slot.SILENCE
                            : Slot.open(port);
            Slot slot = send(sends, port).map(s -> sent(s, port, values)).orElse(omitted);
            said.put(port.name(), slot);
        }
        Map<String, Value> after = new HashMap<>(values.variables());
        for (Automaton.Assignment each : assignments) {
            after.put(
                    each.variable().name(),
                    NaiveValues.within(each.variable().type(), values.of(each.value())));
        }
        return step(said, new Place(target, after));
    }

    private static Slot sent(Send send, Port port, NaiveValues values) {
        if (send.emission() instanceof Automaton.Messages messages) {
            return Slot.just(
                    messages.values().stream()
                            .map(value -> NaiveValues.within(port.type(), values.of(value)))
                            .toList());
        }
        return send.emission() instanceof Automaton.Silence ? Slot.SILENCE : Slot.oneMessage();
    }

    /** One step of each automaton, as far as they agree about the outputs. */
    private List<Step> joint(List<List<Step>> each) {
        List<Step> joint = List.of(new Step(open(), List.of()));
        for (List<Step> own : each) {
            List<Step> longer = new ArrayList<>();
            for (Step first : joint) {
                for (Step second : own) {
                    meet(first, second).ifPresent(longer::add);
                }
            }
            joint = longer;
        }
        return joint;
    }

    private static Optional<Step> meet(Step first, Step second) {
        Map<String, Slot> said = new LinkedHashMap<>();
        for (Map.Entry<String, Slot> slot : first.outputs.entrySet()) {
            Optional<Slot> both = slot.getValue().and(second.outputs.get(slot.getKey()));
            if (both.isEmpty()) {
                return Optional.empty();
            }
            said.put(slot.getKey(), both.get());
        }
        List<Place> places = new ArrayList<>(first.places);
        places.addAll(second.places);
        return Optional.of(new Step(said, places));
    }
}
