package arcomat.report.run;

import arcomat.model.Component;
import arcomat.model.Letter;
import arcomat.model.Port;
import arcomat.model.Trace;
import arcomat.semantics.network.Network;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;

/**
 * What occurs in a trace, in the order of its columns: the component's own ports as declared, then
 * the ports of platform components as they come up; automata in the order of evaluation.
 *
 * @param unit {@code slice} or {@code event}
 */
public record TraceColumns(
        String unit, List<String> inputs, List<String> outputs, List<String> automata) {

    /** What may occur in a run of a network; nothing else does. */
    public static TraceColumns of(Network network) {
        Component component = network.component();
        List<String> automata = new ArrayList<>();
        for (Network.Instance instance : network.instances()) {
            if (!instance.component().platform()) {
                instance.component()
                        .automata()
                        .forEach(each -> automata.add(name(instance.path(), each.name())));
            }
        }
        return new TraceColumns(
                unit(component),
                network.inputs().stream().map(Network.External::name).toList(),
                network.outputs().stream().map(Network.External::name).toList(),
                automata);
    }

    /** Of a component of which no network can be made. */
    public static TraceColumns of(Component component) {
        return of(new Trace(component, List.of(), Optional.empty()));
    }

    static String unit(Component component) {
        return component.profile() == Component.Profile.EVENT_DRIVEN ? "event" : "slice";
    }

    static TraceColumns of(Trace trace) {
        Component component = trace.component();
        Set<String> automata = new LinkedHashSet<>();
        for (Trace.Step step : trace.steps()) {
            step.activities().forEach(activity -> automata.add(nameOf(activity)));
        }
        return new TraceColumns(
                unit(component),
                ports(component.inputs(), trace.received()),
                ports(component.outputs(), trace.shown()),
                List.copyOf(automata));
    }

    private static List<String> ports(List<Port> declared, List<Letter> letters) {
        Set<String> names = new LinkedHashSet<>();
        declared.forEach(port -> names.add(port.name()));
        letters.forEach(letter -> names.addAll(letter.messages().keySet()));
        return List.copyOf(names);
    }

    /** The path of the instance, and the automaton where it has a name. */
    static String nameOf(Trace.Activity activity) {
        return name(activity.instance(), activity.automaton());
    }

    private static String name(String instance, String automaton) {
        if (automaton.isEmpty()) {
            return instance;
        }
        return instance.isEmpty() ? automaton : instance + "." + automaton;
    }

    /** What the automata did in a step, by their names. */
    static Map<String, Trace.Activity> activities(Trace.Step step) {
        Map<String, Trace.Activity> activities = new LinkedHashMap<>();
        step.activities().forEach(activity -> activities.put(nameOf(activity), activity));
        return activities;
    }
}
