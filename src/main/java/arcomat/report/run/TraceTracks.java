package arcomat.report.run;

import arcomat.model.Letter;
import arcomat.model.Trace;
import arcomat.report.page.Drawing;
import arcomat.report.page.Track;
import arcomat.report.page.Track.Kind;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;

/**
 * A trace as tracks: ports, then for each automaton its state, why it changed, and its variables;
 * with a drawing of each automaton.
 */
public final class TraceTracks {
    static final String INPUTS = "inputs";
    public static final String OUTPUTS = "outputs";
    static final String STATES = "states";

    private final Trace trace;
    private final TraceColumns columns;
    private final Map<String, AutomatonTracks> automata = new LinkedHashMap<>();

    TraceTracks(Trace trace) {
        this.trace = trace;
        columns = TraceColumns.of(trace);
        for (Trace.Step step : trace.steps()) {
            for (Trace.Activity activity : step.activities()) {
                automata.computeIfAbsent(
                        TraceColumns.nameOf(activity),
                        name -> new AutomatonTracks(name, trace.component(), activity));
            }
        }
        for (Trace.Step step : trace.steps()) {
            Map<String, Trace.Activity> activities = TraceColumns.activities(step);
            automata.forEach((name, tracks) -> tracks.add(activities.get(name)));
        }
        for (int step = trace.steps().size(); step < length(); step++) {
            automata.values().forEach(tracks -> tracks.add(null));
        }
    }

    /** How many steps there are, one that goes wrong included. */
    int length() {
        return trace.shown().size();
    }

    String unit() {
        return columns.unit();
    }

    List<Track> all() {
        List<Track> tracks = inputs();
        columns.outputs().forEach(port -> tracks.add(output(port)));
        tracks.addAll(states());
        return tracks;
    }

    List<Track> inputs() {
        List<Letter> letters = trace.received();
        List<Track> tracks = new ArrayList<>();
        columns.inputs().forEach(port -> tracks.add(port(INPUTS, port, letters)));
        return tracks;
    }

    /** What came in, on the ports that have messages at all. */
    public static List<Track> inputs(List<Letter> letters) {
        Set<String> ports = new LinkedHashSet<>();
        letters.forEach(letter -> ports.addAll(letter.messages().keySet()));
        return ports.stream().map(port -> port(INPUTS, port, letters)).toList();
    }

    List<String> outputs() {
        return columns.outputs();
    }

    Track output(String port) {
        return port(OUTPUTS, port, trace.shown());
    }

    List<Track> states() {
        List<Track> tracks = new ArrayList<>();
        automata.values().forEach(each -> tracks.addAll(each.tracks()));
        return tracks;
    }

    List<Drawing> drawings(AutomatonDrawing pictures) {
        return automata.values().stream().flatMap(each -> each.drawing(pictures).stream()).toList();
    }

    private static Track port(String group, String port, List<Letter> letters) {
        Track.Builder track = new Track.Builder(group, port, Kind.PORT);
        letters.forEach(letter -> track.addUnlessEmpty(TraceTable.text(letter.messages(port))));
        return track.build();
    }
}
