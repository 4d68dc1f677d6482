package arcomat.report.run;

import arcomat.model.Automaton;
import arcomat.model.Component;
import arcomat.model.Trace;
import arcomat.report.page.Story.Drawing;
import arcomat.report.page.Track;
import arcomat.report.page.Track.Kind;

import org.jspecify.annotations.Nullable;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;

/** What one automaton does in a run, step by step. Where it is asked for nothing, it stays. */
final class AutomatonTracks {
    /** What the state of the sole automaton is called. */
    private static final String SOLE = "state";

    private final String instance;
    private final String group;
    private final boolean sole;
    private final String name;
    private final Optional<Component> component;
    private final Optional<Automaton> automaton;
    private final Track.Builder state;
    private final Track.Builder reason;
    private final Track.Builder nearest;
    private final Map<String, Track.Builder> variables = new LinkedHashMap<>();
    private final Map<String, String> values = new LinkedHashMap<>();
    private String where = "";

    /**
     * @param named empty for the sole automaton of the component that runs
     * @param activity one that the automaton did
     */
    AutomatonTracks(String named, Component whole, Trace.Activity activity) {
        instance = activity.instance();
        group = instance.isEmpty() ? TraceTracks.STATES : Track.PART + instance;
        sole = named.isEmpty();
        name = sole ? SOLE : named;
        component = RunDrawings.part(whole, activity.instance());
        automaton =
                component.stream()
                        .flatMap(each -> each.automata().stream())
                        .filter(each -> each.name().equals(activity.automaton()))
                        .findFirst();
        state = new Track.Builder(group, name, Kind.STATE);
        reason = new Track.Builder(group, name + " because", Kind.REASON);
        nearest = new Track.Builder(group, name + " why not", Kind.REASON);
    }

    /** A step before all others, in which the automaton is where it begins. */
    void begin(Trace.Activity first) {
        where = first.before();
        state.add(where, elements(where));
        reason.addNothing();
    }

    /**
     * @param activity null where it did nothing
     */
    void add(Trace.@Nullable Activity activity) {
        int step = state.steps();
        if (activity == null) {
            reason.addNothing();
        } else {
            if (where.isEmpty()) {
                state.startingAs(activity.before());
            }
            where = activity.after();
            reason.add(CauseText.of(activity.cause()), elements(activity.cause()));
            activity.nearest().ifPresent(each -> nearest.silentUntil(step).add(each.words()));
            activity.variables().forEach((key, value) -> values.put(key, value.toString()));
        }
        if (where.isEmpty()) {
            state.addNothing();
        } else {
            state.add(where, elements(where));
        }
        values.forEach((key, value) -> variable(key).silentUntil(step).add(value));
    }

    private Track.Builder variable(String variable) {
        String full = sole ? variable : name + "." + variable;
        return variables.computeIfAbsent(
                variable, any -> new Track.Builder(group, full, Kind.VARIABLE));
    }

    private List<String> elements(String stateName) {
        return automaton.stream()
                .map(each -> RunDrawings.state(each.states().indexOf(stateName)))
                .toList();
    }

    private static List<String> elements(Trace.Cause cause) {
        return cause instanceof Trace.Taken taken
                ? List.of(RunDrawings.transition(taken.index()))
                : List.of();
    }

    /** The path of whose automaton it is; empty for the whole. */
    String instance() {
        return instance;
    }

    List<Track> tracks() {
        List<Track> tracks = new ArrayList<>(List.of(state.build(), reason.build()));
        if (nearest.steps() > 0) {
            tracks.add(nearest.silentUntil(state.steps()).build());
        }
        variables.values().forEach(each -> tracks.add(each.build()));
        return tracks;
    }

    Optional<Drawing> drawing(RunDrawings pictures) {
        List<String> followed = List.of(name, name + " because");
        return automaton.map(each -> drawing(pictures, component.orElseThrow(), each, followed));
    }

    /** What is not a part of something is called by its own name. */
    private Drawing drawing(
            RunDrawings pictures, Component owner, Automaton drawn, List<String> followed) {
        String title = sole ? owner.title(drawn) : name;
        return pictures.of(title, owner, drawn, followed);
    }
}
