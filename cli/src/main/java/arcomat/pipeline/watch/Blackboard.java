package arcomat.pipeline.watch;

import arcomat.analysis.refinement.Answered;
import arcomat.pipeline.Interruption;
import arcomat.pipeline.check.CheckResult;
import arcomat.pipeline.recheck.CheckState;
import arcomat.pipeline.recheck.Dependencies;
import arcomat.pipeline.watch.Listener.Done;
import arcomat.pipeline.watch.WatchStatus.State;
import arcomat.pipeline.watch.WatchStatus.Step;
import arcomat.simulate.test.StreamTestResult;

import org.jspecify.annotations.Nullable;

import java.util.ArrayList;
import java.util.Collection;
import java.util.EnumMap;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.TreeMap;
import java.util.stream.Stream;

/**
 * All answers that hold for the models as they are, and what is still to be asked. Whoever answers
 * writes here, if nobody has saved anything in between; a listener is told under the same lock, so
 * that it hears things in their order.
 */
final class Blackboard {
    private final Listener listener;
    private final Agenda agenda = new Agenda();
    private final Map<String, List<StreamTestResult>> tests = new TreeMap<>();
    private final Map<String, List<Answered>> promises = new TreeMap<>();
    private final Map<String, WorldEnd> worlds = new TreeMap<>();
    private final Map<Step, State> states = new EnumMap<>(Step.class);
    private CheckResult check = new CheckResult(List.of(), List.of(), List.of());
    private Optional<String> trouble = Optional.empty();
    private @Nullable CheckState files;

    Blackboard(Listener listener) {
        this.listener = listener;
    }

    synchronized WatchStatus situation() {
        return new WatchStatus(
                check,
                tests.values().stream().flatMap(List::stream).toList(),
                states.get(Step.VERIFY) == State.ASKED
                        ? List.of()
                        : promises.values().stream().flatMap(List::stream).toList(),
                List.copyOf(worlds.values()),
                states,
                trouble);
    }

    synchronized void changed(Collection<String> shown) {
        listener.changed(shown);
    }

    /**
     * Models have been checked again: what else is known of those that the change touches is known
     * no more.
     *
     * @param touched files whose findings may be others than before
     * @param now all files
     */
    synchronized void checked(
            CheckResult result, List<String> touched, CheckState now, long nanos) {
        check = result;
        trouble = Optional.empty();
        Set<String> again = new HashSet<>(touched);
        List<CheckState> old = Stream.ofNullable(files).toList();
        Set<String> there = new HashSet<>();
        now.files().forEach(file -> there.add(file.path()));
        old.forEach(
                state ->
                        state.files().stream()
                                .map(CheckState.File::path)
                                .filter(path -> !there.contains(path))
                                .forEach(again::add));
        files = now;
        agenda.add(again, again.isEmpty() ? List.of() : old);
        tests.keySet().removeAll(again);
        states.put(Step.CHECK, State.DONE);
        states.put(Step.TEST, agenda.hasSuites() ? State.ASKED : State.DONE);
        states.put(Step.VERIFY, agenda.hasPromises() ? State.ASKED : State.DONE);
        listener.done(new Done(Step.CHECK, touched.size(), nanos), situation());
    }

    /** Worlds that have to run again; others but those that are there are forgotten. */
    synchronized void touchedWorlds(Collection<String> touched, Collection<String> there) {
        agenda.addWorlds(touched);
        agenda.worlds().stream().filter(each -> !there.contains(each)).forEach(agenda::worldDone);
        worlds.keySet().retainAll(there);
        worlds.keySet().removeAll(agenda.worlds());
        states.put(Step.WORLD, agenda.hasWorlds() ? State.ASKED : State.DONE);
    }

    synchronized Set<String> suites(Dependencies now) {
        return agenda.suites(now);
    }

    synchronized Set<String> scope(Dependencies now) {
        return agenda.scope(now);
    }

    synchronized Set<String> worlds() {
        return agenda.worlds();
    }

    /**
     * @param waiting suites that could not be run: models have errors
     */
    synchronized void tested(
            Set<String> suites,
            List<StreamTestResult> results,
            Set<String> waiting,
            long nanos,
            Interruption interruption) {
        interruption.goOn();
        tests.keySet().removeAll(suites);
        for (StreamTestResult each : results) {
            String file = each.test().span().file().path();
            tests.computeIfAbsent(file, any -> new ArrayList<>()).add(each);
        }
        agenda.testsDone(waiting);
        states.put(Step.TEST, agenda.hasSuites() ? State.BLOCKED : State.DONE);
        if (!suites.isEmpty()) {
            listener.done(new Done(Step.TEST, suites.size(), nanos), situation());
        }
    }

    /**
     * @param scope files that were asked about
     * @param waiting those of them about which nothing can be said: models have errors
     */
    synchronized void shown(
            Set<String> scope,
            List<Answered> answers,
            Set<String> waiting,
            long nanos,
            Interruption interruption) {
        interruption.goOn();
        promises.keySet().removeAll(scope);
        promises.keySet().retainAll(paths());
        for (Answered each : answers) {
            String file = each.place().file().path();
            promises.computeIfAbsent(file, any -> new ArrayList<>()).add(each);
        }
        agenda.promisesDone(waiting);
        states.put(Step.VERIFY, agenda.hasPromises() ? State.BLOCKED : State.DONE);
        if (!answers.isEmpty() || agenda.hasPromises()) {
            listener.done(new Done(Step.VERIFY, answers.size(), nanos), situation());
        }
    }

    private Set<String> paths() {
        Set<String> paths = new HashSet<>();
        check.paths().forEach(paths::add);
        return paths;
    }

    synchronized void ended(WorldEnd end, long nanos, Interruption interruption) {
        interruption.goOn();
        worlds.put(end.world(), end);
        agenda.worldDone(end.world());
        states.put(Step.WORLD, agenda.hasWorlds() ? State.ASKED : State.DONE);
        listener.done(new Done(Step.WORLD, 1, nanos), situation());
    }

    synchronized void settled(Interruption interruption) {
        interruption.goOn();
        listener.settled(situation());
    }

    /** The tool has failed; what it was asked stays open until the next change. */
    synchronized void failed(Throwable error, Interruption interruption) {
        if (!interruption.isEnded()) {
            trouble = Optional.of(error.toString());
            listener.settled(situation());
        }
    }
}
