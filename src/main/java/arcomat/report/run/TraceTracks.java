package arcomat.report.run;

import static java.util.stream.Collectors.groupingBy;

import arcomat.model.Letter;
import arcomat.model.Trace;
import arcomat.report.page.Story.Drawing;
import arcomat.report.page.Track;
import arcomat.report.page.Track.Kind;

import java.util.ArrayList;
import java.util.Collection;
import java.util.LinkedHashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;

/**
 * A trace as tracks: ports, then for each automaton its state, why it changed, and its variables,
 * part by part as the architecture is; with drawings that follow the run.
 */
public final class TraceTracks {
    static final String INPUTS = "inputs";
    public static final String OUTPUTS = "outputs";
    static final String STATES = "states";

    private final Trace trace;
    private final TraceColumns columns;
    private final Map<String, AutomatonTracks> automata = new LinkedHashMap<>();
    private final PartTracks parts;

    /** Of a run that tells what its parts send if any of them ever sends something. */
    TraceTracks(Trace trace) {
        this(trace, trace.steps().stream().anyMatch(step -> !step.between().isSilent()), false);
    }

    /** Of a run that tells what its parts send. */
    public static TraceTracks told(Trace trace) {
        return new TraceTracks(trace, true, false);
    }

    /** As {@link #told}; the first step has no activities, and shows where automata begin. */
    public static TraceTracks begun(Trace trace) {
        return new TraceTracks(trace, true, true);
    }

    private TraceTracks(Trace trace, boolean told, boolean begun) {
        this.trace = trace;
        columns = TraceColumns.of(trace);
        for (Trace.Step step : trace.steps()) {
            for (Trace.Activity activity : step.activities()) {
                automata.computeIfAbsent(
                        TraceColumns.nameOf(activity),
                        name -> {
                            AutomatonTracks tracks =
                                    new AutomatonTracks(name, trace.component(), activity);
                            if (begun) {
                                tracks.begin();
                            }
                            return tracks;
                        });
            }
        }
        for (Trace.Step step : trace.steps().subList(begun ? 1 : 0, trace.steps().size())) {
            Map<String, List<Trace.Activity>> activities =
                    step.activities().stream().collect(groupingBy(TraceColumns::nameOf));
            automata.forEach(
                    (name, tracks) -> tracks.add(activities.getOrDefault(name, List.of())));
        }
        for (int step = trace.steps().size(); step < length(); step++) {
            automata.values().forEach(tracks -> tracks.add(List.of()));
        }
        parts = new PartTracks(trace, told);
    }

    /** How many steps there are, one that goes wrong included. */
    int length() {
        return trace.shown().size();
    }

    String unit() {
        return columns.unit();
    }

    List<Track> all() {
        List<Track> tracks = new ArrayList<>(inputs());
        columns.outputs().forEach(port -> tracks.add(output(port)));
        tracks.addAll(states());
        return tracks;
    }

    List<Track> inputs() {
        return inputs(columns.inputs(), trace.received());
    }

    /** What came in, on the ports that have messages at all. */
    public static List<Track> inputs(List<Letter> letters) {
        Set<String> ports = new LinkedHashSet<>();
        letters.forEach(letter -> ports.addAll(letter.messages().keySet()));
        return inputs(ports, letters);
    }

    private static List<Track> inputs(Collection<String> ports, List<Letter> letters) {
        return ports.stream().map(port -> port(INPUTS, port, letters)).toList();
    }

    List<String> outputs() {
        return columns.outputs();
    }

    Track output(String port) {
        return port(OUTPUTS, port, trace.shown());
    }

    /** What is inside: the automata of the whole, or of each part behind what that part sends. */
    public List<Track> states() {
        List<Track> tracks = new ArrayList<>(states(""));
        for (String part : parts.paths()) {
            tracks.addAll(parts.outputs(part));
            tracks.addAll(states(part));
        }
        return tracks;
    }

    private List<Track> states(String instance) {
        return automata.values().stream()
                .filter(each -> each.instance().equals(instance))
                .flatMap(each -> each.tracks().stream())
                .toList();
    }

    /** The parts with what they send, then each automaton. */
    public List<Drawing> drawings(RunDrawings pictures) {
        List<Drawing> drawings = new ArrayList<>();
        parts.drawing(pictures).ifPresent(drawings::add);
        automata.values().forEach(each -> each.drawing(pictures).ifPresent(drawings::add));
        return drawings;
    }

    private static Track port(String group, String port, List<Letter> letters) {
        return Track.of(
                group,
                port,
                Kind.PORT,
                letters.stream().map(letter -> TraceTable.text(letter.messages(port))));
    }
}
