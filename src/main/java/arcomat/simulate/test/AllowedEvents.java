package arcomat.simulate.test;

import arcomat.model.Letter;
import arcomat.model.StreamTest;
import arcomat.model.Value;
import arcomat.semantics.Execution;
import arcomat.semantics.automaton.ComponentSemantics.JointReaction;
import arcomat.semantics.automaton.ComponentSemantics.JointStart;
import arcomat.semantics.automaton.ComponentSemantics.Prospect;
import arcomat.semantics.automaton.Input;
import arcomat.semantics.expression.Sent;
import arcomat.semantics.network.Network;

import org.jspecify.annotations.Nullable;

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
final class AllowedEvents extends AllowedBehaviour {
    /** More runs than that are not followed. */
    static final int MOST_RUNS = 10_000;

    /** Within one event, more than that are taken for too many. */
    private static final int MOST_MOMENTS = 200_000;

    private final Posts posts;
    private int event;
    private @Nullable String gaveUp;

    AllowedEvents(Network network, StreamTest test, Collection<Value> mentioned) {
        super(network);
        posts = new Posts(network, test, mentioned);
    }

    /** Why not all runs were followed; empty if they were. */
    Optional<String> gaveUp() {
        return Optional.ofNullable(gaveUp).or(posts::untried);
    }

    /** Whether a run has shown all that is expected. */
    boolean isComplete(PossibleRun run) {
        return posts.isComplete(run);
    }

    /** The beginnings, and what they cause. */
    Collection<PossibleRun> starts() {
        int[] ports = network.instances().stream().mapToInt(i -> i.inputSignals().size()).toArray();
        List<PossibleRun> runs = List.of(new PossibleRun(ports, posts.streams()));
        for (int i = 0; i < behaviours.size(); i++) {
            List<PossibleRun> next = new ArrayList<>();
            for (PossibleRun before : runs) {
                for (JointStart start : behaviours.get(i).starts()) {
                    PossibleRun after = before.copy();
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
    Collection<PossibleRun> event(Collection<PossibleRun> runs, Letter letter, int number) {
        event = number;
        lastProblem = null;
        posts.forgetProblem();
        List<PossibleRun> next = new ArrayList<>();
        for (PossibleRun before : runs) {
            PossibleRun after = before.copy();
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
    private Collection<PossibleRun> worked(List<PossibleRun> runs) {
        Map<Object, PossibleRun> quiet = new LinkedHashMap<>();
        Map<Object, PossibleRun> met = new LinkedHashMap<>();
        List<PossibleRun> current = runs;
        for (int reactions = 0; !current.isEmpty(); reactions++) {
            List<PossibleRun> next = new ArrayList<>();
            // A single run need not be remembered: it ends, or is taken to circle.
            boolean many = !met.isEmpty() || current.size() > 1;
            for (PossibleRun run : current) {
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

    private static boolean keepBest(Map<Object, PossibleRun> runs, PossibleRun run) {
        PossibleRun known = runs.get(run.state());
        boolean better = known == null || run.isBetterThan(known);
        if (better) {
            runs.put(run.state(), run);
        }
        return better;
    }

    private void react(PossibleRun before, List<PossibleRun> next) {
        int instance = before.next();
        PossibleRun taken = before.copy();
        Input input = Input.of(taken.take(instance));
        Prospect prospect = prospect(instance, taken.configurations.get(instance), input);
        for (JointReaction reaction : prospect.reactions()) {
            PossibleRun after = taken.copy();
            after.configurations.set(instance, reaction.next());
            send(after, instance, reaction.output().ports(), next);
        }
    }

    private void send(PossibleRun run, int instance, List<Sent> sent, List<PossibleRun> next) {
        boolean chaotic = isChaotic(run.configurations.get(instance));
        List<Integer> signals = network.instances().get(instance).outputSignals();
        List<PossibleRun> runs = List.of(run);
        for (int i = 0; i < sent.size(); i++) {
            List<PossibleRun> longer = new ArrayList<>();
            for (PossibleRun each : runs) {
                for (List<Value> messages : posts.options(each, signals.get(i), sent.get(i))) {
                    PossibleRun copy = each.copy();
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
