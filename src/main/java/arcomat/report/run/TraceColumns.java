package arcomat.report.run;

import arcomat.model.Component;
import arcomat.model.Letter;
import arcomat.model.Port;
import arcomat.model.Trace;

import java.util.LinkedHashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;

/**
 * What occurs in a trace, in the order of its columns: the component's own ports as declared, then
 * the ports of platform components as they come up; automata in the order of evaluation.
 *
 * @param unit {@code slice} or {@code event}
 */
record TraceColumns(String unit, List<String> inputs, List<String> outputs, List<String> automata) {

    static TraceColumns of(Trace trace) {
        Component component = trace.component();
        boolean events = component.profile() == Component.Profile.EVENT_DRIVEN;
        Set<String> automata = new LinkedHashSet<>();
        for (Trace.Step step : trace.steps()) {
            step.activities().forEach(activity -> automata.add(nameOf(activity)));
        }
        return new TraceColumns(
                events ? "event" : "slice",
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
        if (activity.automaton().isEmpty()) {
            return activity.instance();
        }
        return activity.instance().isEmpty()
                ? activity.automaton()
                : activity.instance() + "." + activity.automaton();
    }

    /** What the automata did in a step, by their names. */
    static Map<String, Trace.Activity> activities(Trace.Step step) {
        Map<String, Trace.Activity> activities = new LinkedHashMap<>();
        step.activities().forEach(activity -> activities.put(nameOf(activity), activity));
        return activities;
    }
}
