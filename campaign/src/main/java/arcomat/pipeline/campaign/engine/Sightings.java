package arcomat.pipeline.campaign.engine;

import arcomat.campaign.Watched;
import arcomat.pipeline.world.Onlooker;
import arcomat.pipeline.world.Witness.Instruments;
import arcomat.sim.device.LineNotes;
import arcomat.sim.load.Probe;
import arcomat.world.Scene;

import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.TreeMap;
import java.util.TreeSet;

/** What robots that watch themselves have seen in a run. */
final class Sightings implements Onlooker {
    private static final String MONITOR = "arcomat.rt.Monitor";
    private static final String VIOLATION = "violate";
    private static final String TOO_MUCH = "tooMany";

    private final Map<String, String> monitors;
    private final Onlooker beside;
    private final Set<String> violated = new TreeSet<>();
    private final Map<String, String> unknown = new TreeMap<>();

    /**
     * @param monitors columns by the full names of classes
     * @param beside sees the same
     */
    Sightings(Map<String, String> monitors, Onlooker beside) {
        this.monitors = monitors;
        this.beside = beside;
    }

    /** Where programs tell of it: all their monitors extend one class. */
    static List<Probe> probes(Map<String, String> monitors) {
        return monitors.isEmpty()
                ? List.of()
                : List.of(new Probe(MONITOR, VIOLATION), new Probe(MONITOR, TOO_MUCH));
    }

    @Override
    public void see(Scene scene, Instruments instruments) {
        beside.see(scene, instruments);
    }

    @Override
    public void noted(String robot, List<LineNotes> notes) {
        beside.noted(robot, notes);
    }

    @Override
    public void entered(String robot, Object object, String method) {
        beside.entered(robot, object, method);
        String column = monitors.get(object.getClass().getName());
        if (column != null && method.equals(VIOLATION)) {
            violated.add(column);
        } else if (column != null && method.equals(TOO_MUCH)) {
            unknown.putIfAbsent(column, robot);
        }
    }

    @Override
    public void left(String robot, Object object, String method) {
        beside.left(robot, object, method);
    }

    List<Double> answers(List<Watched> columns) {
        return columns.stream().map(each -> violated.contains(each.name()) ? 1.0 : 0.0).toList();
    }

    /** Why it cannot be told whether something was violated. */
    Optional<String> doubt() {
        return unknown.entrySet().stream()
                .filter(each -> !violated.contains(each.getKey()))
                .map(
                        each ->
                                "%s: the monitor of %s gave up with too many possible runs"
                                        .formatted(each.getKey(), each.getValue()))
                .findFirst();
    }
}
