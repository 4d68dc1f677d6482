package arcomat.pipeline.watch;

import arcomat.pipeline.recheck.CheckState;
import arcomat.pipeline.recheck.Dependencies;

import java.util.ArrayList;
import java.util.Collection;
import java.util.HashSet;
import java.util.List;
import java.util.Set;

/**
 * What has to be asked again, from the change that touches it to the answer. A promise depends on
 * who uses a component, with which arguments: all files that are connected with a touched one, as
 * they were and as they are, are asked about.
 */
final class Agenda {
    private final Set<String> suites = new HashSet<>();
    private final Set<String> touched = new HashSet<>();
    private final Set<String> worlds = new HashSet<>();
    private final List<CheckState> before = new ArrayList<>();

    /**
     * Something has changed.
     *
     * @param files whose findings may be others than before, and those that are gone
     * @param old the files before that
     */
    void add(Collection<String> files, List<CheckState> old) {
        files.stream().filter(file -> file.endsWith(".mt")).forEach(suites::add);
        touched.addAll(files);
        before.addAll(old);
    }

    void addWorlds(Collection<String> files) {
        worlds.addAll(files);
    }

    /** Suites that are there. */
    Set<String> suites(Dependencies now) {
        suites.retainAll(now.named());
        return Set.copyOf(suites);
    }

    /** All files that the answers to promises may depend on; named ones only. */
    Set<String> scope(Dependencies now) {
        Set<String> scope = new HashSet<>(touched);
        for (CheckState old : before) {
            scope.addAll(Dependencies.of(old).connectedWith(scope));
        }
        Set<String> connected = new HashSet<>(now.connectedWith(scope));
        connected.retainAll(now.named());
        return connected;
    }

    Set<String> worlds() {
        return Set.copyOf(worlds);
    }

    /**
     * Tests have been run.
     *
     * @param waiting those that could not be
     */
    void testsDone(Set<String> waiting) {
        suites.retainAll(waiting);
    }

    /**
     * Promises have been asked about.
     *
     * @param waiting files about which nothing could be said
     */
    void promisesDone(Set<String> waiting) {
        before.clear();
        touched.clear();
        touched.addAll(waiting);
    }

    void worldDone(String world) {
        worlds.remove(world);
    }

    boolean hasSuites() {
        return !suites.isEmpty();
    }

    boolean hasPromises() {
        return !touched.isEmpty();
    }

    boolean hasWorlds() {
        return !worlds.isEmpty();
    }
}
