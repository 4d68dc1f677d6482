package arcomat.report;

import arcomat.model.Letter;
import arcomat.model.Trace;
import arcomat.model.Value;
import arcomat.report.page.Track;
import arcomat.report.page.Track.Kind;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.function.Function;

/**
 * A trace as tracks: ports, then for each automaton its state, why it changed, and its variables.
 * In drawings, states and transitions are called {@code state 0}, {@code transition 0} by their
 * index.
 */
final class TraceTracks {
    static final String INPUTS = "inputs";
    static final String OUTPUTS = "outputs";
    static final String STATES = "states";

    private TraceTracks() {}

    static List<Track> of(Trace trace, TraceColumns columns) {
        List<Track> tracks = new ArrayList<>();
        columns.inputs()
                .forEach(port -> tracks.add(port(INPUTS, port, trace, Trace.Step::inputs)));
        columns.outputs()
                .forEach(port -> tracks.add(port(OUTPUTS, port, trace, Trace.Step::outputs)));
        Map<String, AutomatonTracks> automata = new LinkedHashMap<>();
        columns.automata().forEach(name -> automata.put(name, new AutomatonTracks(name)));
        for (Trace.Step step : trace.steps()) {
            Map<String, Trace.Activity> activities = TraceColumns.activities(step);
            automata.forEach((name, track) -> track.add(activities.get(name)));
        }
        automata.values().forEach(each -> tracks.addAll(each.build()));
        return tracks;
    }

    private static Track port(
            String group, String port, Trace trace, Function<Trace.Step, Letter> letter) {
        Track.Builder track = new Track.Builder(group, port, Kind.PORT);
        for (Trace.Step step : trace.steps()) {
            List<Value> messages = letter.apply(step).messages(port);
            if (messages.isEmpty()) {
                track.addNothing();
            } else {
                track.add(TraceTable.text(messages));
            }
        }
        return track.build();
    }

    /** What one automaton does. In an event it may be asked for nothing: it stays where it is. */
    private static final class AutomatonTracks {
        private final String name;
        private final Track.Builder state;
        private final Track.Builder reason;
        private final Map<String, Track.Builder> variables = new LinkedHashMap<>();
        private final Map<String, String> values = new LinkedHashMap<>();
        private String where = "";

        AutomatonTracks(String name) {
            this.name = name.isEmpty() ? "state" : name;
            this.state = new Track.Builder(STATES, this.name, Kind.STATE);
            this.reason = new Track.Builder(STATES, this.name + " because", Kind.REASON);
        }

        void add(Trace.Activity activity) {
            int step = state.steps();
            if (activity == null) {
                reason.addNothing();
            } else {
                if (where.isEmpty()) {
                    state.startingAs(activity.before());
                }
                where = activity.after();
                reason.add(CauseText.of(activity.cause()), elements(activity.cause()));
                activity.variables()
                        .forEach((variable, value) -> values.put(variable, value.toString()));
            }
            if (where.isEmpty()) {
                state.addNothing();
            } else {
                state.add(where);
            }
            values.forEach(
                    (variable, value) ->
                            variables
                                    .computeIfAbsent(variable, this::variable)
                                    .silentUntil(step)
                                    .add(value));
        }

        private Track.Builder variable(String variable) {
            return new Track.Builder(STATES, prefix() + variable, Kind.VARIABLE);
        }

        private String prefix() {
            return name.equals("state") ? "" : name + ".";
        }

        private static List<String> elements(Trace.Cause cause) {
            return cause instanceof Trace.Taken taken
                    ? List.of("transition " + taken.index())
                    : List.of();
        }

        List<Track> build() {
            List<Track> tracks = new ArrayList<>(List.of(state.build(), reason.build()));
            variables.values().forEach(each -> tracks.add(each.build()));
            return tracks;
        }
    }
}
