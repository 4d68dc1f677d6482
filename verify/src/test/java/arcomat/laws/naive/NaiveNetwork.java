package arcomat.laws.naive;

import arcomat.model.Automaton;
import arcomat.model.Component;
import arcomat.model.Component.Composite;
import arcomat.model.Component.Connection;
import arcomat.model.Component.Endpoint;
import arcomat.model.Port;

import java.util.ArrayList;
import java.util.HashSet;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;

/**
 * Atomic parts and how they are connected. A signal is named after its sender, {@code .x} for an
 * input of the whole, {@code .p1.u} for an output of a part; an input without a sender is missing.
 *
 * @param atoms each after those whose messages it reads in the slice in which they are sent
 * @param outputs per output of the whole its signal
 */
record NaiveNetwork(Component whole, List<Atom> atoms, Map<String, String> outputs) {

    /**
     * @param inputs per input port its signal
     */
    record Atom(String path, NaiveAutomata automata, Map<String, String> inputs) {
        String signal(Port output) {
            return path + "." + output.name();
        }

        List<Port> ports() {
            return automata.component().outputs();
        }
    }

    /** A component at its place; the whole has no parent. */
    private record Place(String path, Component component, Place parent, String name) {

        List<Place> parts() {
            return ((Composite) component.body())
                    .parts().stream()
                            .map(
                                    p ->
                                            new Place(
                                                    path + "." + p.name(),
                                                    p.component(),
                                                    this,
                                                    p.name()))
                            .toList();
        }

        boolean isWhole() {
            return parent == null;
        }
    }

    static NaiveNetwork of(Component whole, List<Automaton> automata) {
        Place top = new Place("", whole, null, "");
        Map<String, String> outputs = new LinkedHashMap<>();
        if (!whole.isComposite() || !automata.isEmpty()) {
            Map<String, String> inputs = new LinkedHashMap<>();
            whole.inputs().forEach(p -> inputs.put(p.name(), "." + p.name()));
            whole.outputs().forEach(p -> outputs.put(p.name(), "<." + p.name()));
            List<Automaton> own = whole.isComposite() ? automata : whole.automata();
            Atom atom =
                    new Atom(
                            "<",
                            new NaiveAutomata(whole, automata.isEmpty() ? own : automata),
                            inputs);
            return new NaiveNetwork(whole, List.of(atom), outputs);
        }
        List<Atom> atoms = new ArrayList<>();
        collect(top, atoms);
        whole.outputs()
                .forEach(p -> leaving(top, p.name()).ifPresent(s -> outputs.put(p.name(), s)));
        boolean timed = whole.profile() == Component.Profile.TIME_SYNCHRONOUS;
        return new NaiveNetwork(whole, timed ? ordered(atoms) : atoms, outputs);
    }

    private static void collect(Place place, List<Atom> atoms) {
        if (place.component.isComposite()) {
            place.parts().forEach(part -> collect(part, atoms));
            return;
        }
        Map<String, String> inputs = new LinkedHashMap<>();
        for (Port port : place.component.inputs()) {
            entering(place, port.name()).ifPresent(signal -> inputs.put(port.name(), signal));
        }
        atoms.add(
                new Atom(
                        place.path,
                        new NaiveAutomata(place.component, place.component.automata()),
                        inputs));
    }

    /** The signal on an input port. */
    private static Optional<String> entering(Place place, String port) {
        return place.isWhole()
                ? Optional.of("." + port)
                : sender(place.parent, new Endpoint(Optional.of(place.name), port));
    }

    /** The signal on an output port. */
    private static Optional<String> leaving(Place place, String port) {
        return place.component.isComposite()
                ? sender(place, new Endpoint(Optional.empty(), port))
                : Optional.of(place.path + "." + port);
    }

    private static Optional<String> sender(Place inside, Endpoint target) {
        for (Connection each : ((Composite) inside.component.body()).connections()) {
            if (each.target().equals(target)) {
                Endpoint source = each.source();
                return source.part().isEmpty()
                        ? entering(inside, source.port())
                        : leaving(
                                inside.parts().stream()
                                        .filter(p -> p.name.equals(source.part().get()))
                                        .findFirst()
                                        .orElseThrow(),
                                source.port());
            }
        }
        return Optional.empty();
    }

    private static List<Atom> ordered(List<Atom> atoms) {
        List<Atom> ordered = new ArrayList<>();
        List<Atom> left = new ArrayList<>(atoms);
        while (!left.isEmpty()) {
            Set<String> waiting = new HashSet<>();
            left.forEach(
                    a ->
                            a.ports().stream()
                                    .filter(p -> p.delay() == 0)
                                    .forEach(p -> waiting.add(a.signal(p))));
            Atom next =
                    left.stream()
                            .filter(a -> a.inputs.values().stream().noneMatch(waiting::contains))
                            .findFirst()
                            .orElseThrow(() -> new IllegalArgumentException("a circle"));
            ordered.add(next);
            left.remove(next);
        }
        return ordered;
    }

    /** The signals that depend on an input of the whole in the same slice. */
    Set<String> atOnce(String input) {
        Set<String> found = new HashSet<>(Set.of("." + input));
        for (Atom atom : atoms) {
            if (atom.inputs.values().stream().anyMatch(found::contains)) {
                atom.ports().stream()
                        .filter(p -> p.delay() == 0)
                        .forEach(p -> found.add(atom.signal(p)));
            }
        }
        return found;
    }

    /** The signals of outputs with a delay. */
    Set<String> late() {
        Set<String> late = new HashSet<>();
        atoms.forEach(
                a ->
                        a.ports().stream()
                                .filter(p -> p.delay() == 1)
                                .forEach(p -> late.add(a.signal(p))));
        return late;
    }

    /** The signals that somebody reads or sees. */
    Set<String> seen() {
        Set<String> seen = new HashSet<>(outputs.values());
        atoms.forEach(a -> seen.addAll(a.inputs.values()));
        return seen;
    }
}
