package arcomat.simulate.test;

import arcomat.model.Letter;
import arcomat.model.StreamTest;
import arcomat.model.Value;
import arcomat.semantics.Execution;
import arcomat.semantics.automaton.Behaviour;
import arcomat.semantics.automaton.Behaviour.JointReaction;
import arcomat.semantics.automaton.Behaviour.JointStart;
import arcomat.semantics.automaton.Behaviour.Prospect;
import arcomat.semantics.automaton.Configuration;
import arcomat.semantics.automaton.Input;
import arcomat.semantics.expression.Sent;
import arcomat.semantics.network.Network;

import java.util.ArrayList;
import java.util.Collection;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;

/**
 * All runs of an event-driven network at once that show, up to now, a beginning of what a test
 * expects. What is left open is what is expected, or, where only parts receive it, some of what it
 * may be: what is not tried is remembered.
 */
final class AllowedEvents {
    /** More runs than that are not followed. */
    static final int MOST_RUNS = 10_000;

    /** Within one event, more than that are taken for too many. */
    private static final int MOST_MOMENTS = 200_000;

    private final Network network;
    private final List<Behaviour> behaviours;
    private final Posts posts;
    private int event;
    private String lastProblem;
    private String gaveUp;

    AllowedEvents(Network network, StreamTest test, Collection<Value> mentioned) {
        this.network = network;
        behaviours = Behaviour.ofParts(network);
        posts = new Posts(network, test, mentioned);
    }

    Network network() {
        return network;
    }

    /** Why the last run that could not go on could not. */
    Optional<String> lastProblem() {
        return Optional.ofNullable(lastProblem);
    }

    /** Why not all runs were followed; empty if they were. */
    Optional<String> gaveUp() {
        return Optional.ofNullable(gaveUp).or(posts::untried);
    }

    /** Whether a run has shown all that is expected. */
    boolean isComplete(EventRun run) {
        return posts.isComplete(run);
    }

    /** The beginnings, and what they cause. */
    Collection<EventRun> starts() {
        int[] ports = network.instances().stream().mapToInt(i -> i.inputSignals().size()).toArray();
        List<EventRun> runs = List.of(new EventRun(ports, posts.streams()));
        for (int i = 0; i < behaviours.size(); i++) {
            List<EventRun> next = new ArrayList<>();
            for (EventRun before : runs) {
                for (JointStart start : behaviours.get(i).starts()) {
                    EventRun after = before.copy();
                    after.configurations.add(start.configurations());
                    send(after, i, start.output().ports(), next);
                }
            }
            runs = next;
        }
        if (runs.isEmpty() && lastProblem == null) {
            lastProblem = "its automata contradict each other to begin with";
        }
        return worked(runs);
    }

    /** All ways to work off an event. */
    Collection<EventRun> event(Collection<EventRun> runs, Letter letter, int number) {
        event = number;
        lastProblem = null;
        posts.forgetProblem();
        List<EventRun> next = new ArrayList<>();
        for (EventRun before : runs) {
            EventRun after = before.copy();
            after.begin();
            boolean fits = true;
            for (Network.External external : network.inputs()) {
                for (Value message : letter.messages(external.name())) {
                    fits &= posts.send(after, external.signal(), message);
                }
            }
            if (fits) {
                next.add(after);
            }
        }
        return worked(next);
    }

    /** Lets all react to all that waits, in every way. */
    private Collection<EventRun> worked(List<EventRun> runs) {
        Map<Object, EventRun> quiet = new LinkedHashMap<>();
        Map<Object, EventRun> met = new LinkedHashMap<>();
        List<EventRun> current = runs;
        for (int reactions = 0; !current.isEmpty(); reactions++) {
            List<EventRun> next = new ArrayList<>();
            // A single run need not be remembered: it ends, or is taken to circle.
            boolean many = !met.isEmpty() || current.size() > 1;
            for (EventRun run : current) {
                if (run.isQuiet()) {
                    keepBest(quiet, run);
                } else if (!many || keepBest(met, run)) {
                    react(run, next);
                }
            }
            current = next;
            if (quiet.size() > MOST_RUNS || met.size() > MOST_MOMENTS) {
                gaveUp = tooMany(quiet.size() > MOST_RUNS);
                break;
            }
            if (reactions > Execution.MOST_REACTIONS) {
                break;
            }
        }
        if (quiet.isEmpty() && lastProblem == null) {
            lastProblem = posts.problem().orElse("messages circle without end");
        }
        return quiet.values();
    }

    private static String tooMany(boolean runs) {
        return "more than "
                + (runs ? MOST_RUNS + " possible runs" : MOST_MOMENTS + " reactions to one event")
                + ": the test leaves too much open";
    }

    private static boolean keepBest(Map<Object, EventRun> runs, EventRun run) {
        EventRun known = runs.get(run.state());
        boolean better = known == null || run.isBetterThan(known);
        if (better) {
            runs.put(run.state(), run);
        }
        return better;
    }

    private void react(EventRun before, List<EventRun> next) {
        int instance = before.next();
        EventRun taken = before.copy();
        Input input = Input.of(taken.take(instance));
        Prospect prospect =
                behaviours.get(instance).prospect(taken.configurations.get(instance), input);
        prospect.errors()
                .forEach(
                        error ->
                                lastProblem =
                                        network.instances().get(instance).with(error.message()));
        if (prospect.isContradiction()) {
            lastProblem =
                    network.instances().get(instance).with("its automata contradict each other");
        }
        for (JointReaction reaction : prospect.reactions()) {
            EventRun after = taken.copy();
            after.configurations.set(instance, reaction.next());
            send(after, instance, reaction.output().ports(), next);
        }
    }

    private void send(EventRun run, int instance, List<Sent> sent, List<EventRun> next) {
        List<Configuration> sender = run.configurations.get(instance);
        boolean chaotic = sender.isEmpty() || sender.contains(Configuration.CHAOS);
        List<Integer> signals = network.instances().get(instance).outputSignals();
        List<EventRun> runs = List.of(run);
        for (int i = 0; i < sent.size(); i++) {
            List<EventRun> longer = new ArrayList<>();
            for (EventRun each : runs) {
                for (List<Value> messages : posts.options(each, signals.get(i), sent.get(i))) {
                    EventRun copy = each.copy();
                    if (!(sent.get(i) instanceof Sent.Messages)
                            && chaotic
                            && posts.isOfUse(signals.get(i))) {
                        copy.lower(Standing.VACUOUS, event);
                        copy.chaotic = copy.chaotic < 0 ? instance : copy.chaotic;
                    }
                    if (posts.send(copy, signals.get(i), messages)) {
                        longer.add(copy);
                    }
                }
            }
            runs = longer;
        }
        next.addAll(runs);
    }
}
