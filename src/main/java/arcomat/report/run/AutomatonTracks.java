package arcomat.report.run;

import arcomat.model.Automaton;
import arcomat.model.Component;
import arcomat.model.Refusal;
import arcomat.model.Trace;
import arcomat.report.page.Story.Drawing;
import arcomat.report.page.Track;
import arcomat.report.page.Track.Kind;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.function.Function;
import java.util.stream.Collectors;
import java.util.stream.Stream;

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
    private String where;

    /**
     * @param named empty for the sole automaton of the component that runs
     * @param activity the first that the automaton did; until then it is where that finds it
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
        where = activity.before();
    }

    /** A step before all others, in which the automaton is where it begins. */
    void begin() {
        state.add(where, elements(where));
        reason.addNothing();
    }

    /**
     * @param activities what it did in a step, one after the other: several where events drive it
     */
    void add(List<Trace.Activity> activities) {
        int step = state.steps();
        if (step == 0) {
            state.startingAs(where);
        }
        if (activities.isEmpty()) {
            reason.addNothing();
        } else {
            because(activities);
            String refusals =
                    inTurn(activities, each -> each.nearest().stream().map(Refusal::words));
            if (!refusals.isEmpty()) {
                nearest.silentUntil(step).add(refusals);
            }
            Trace.Activity last = activities.get(activities.size() - 1);
            where = last.after();
            last.variables().forEach((key, value) -> values.put(key, value.toString()));
        }
        state.add(where, elements(where));
        values.forEach((key, value) -> variable(key).silentUntil(step).add(value));
    }

    private void because(List<Trace.Activity> activities) {
        reason.add(
                inTurn(activities, each -> Stream.of(CauseText.of(each.cause()))),
                activities.stream().flatMap(each -> elements(each.cause()).stream()).toList());
    }

    private static String inTurn(
            List<Trace.Activity> activities, Function<Trace.Activity, Stream<String>> words) {
        return activities.stream().flatMap(words).collect(Collectors.joining("; then "));
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
