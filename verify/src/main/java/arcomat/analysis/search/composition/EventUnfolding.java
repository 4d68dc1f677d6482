package arcomat.analysis.search.composition;

import arcomat.analysis.search.Budget;
import arcomat.analysis.search.composition.EventReactions.Branches;
import arcomat.analysis.search.letter.Representatives;
import arcomat.model.Component;
import arcomat.model.Port;
import arcomat.model.Value;
import arcomat.semantics.automaton.ComponentSemantics;
import arcomat.semantics.expression.Sent;
import arcomat.semantics.network.Network;
import arcomat.semantics.value.InputAbstraction;
import arcomat.semantics.value.InputAbstraction.PortAbstraction;

import org.jspecify.annotations.Nullable;

import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.Deque;
import java.util.List;
import java.util.Optional;

/**
 * An event-driven network, event by event, as {@link Network} says how it runs: a step is an event
 * and all that follows from it until every queue is empty. The beginning is the initial outputs and
 * what they cause. Runs that never end, and queues that overflow, are errors.
 *
 * <p>A letter has one event, and what latched external ports hold at that time. One without an
 * event stands for an event that only others have a port for.
 */
public final class EventUnfolding implements Unfolding {
    /** Longer runs are not followed. */
    public static final int LONGEST = 5_000;

    /** As many reactions to one event are tried, all its runs together. */
    public static final int MOST_REACTIONS = 50_000;

    private final Budget budget;
    private final Network network;
    private final EventWiring wiring;
    private final EventReactions parts;
    private final List<Port> inputs;
    private final List<PortAbstraction> firstLooks;
    private final List<Wiring.Reader> registers;

    /**
     * @param compared names of the outputs that the outside looks at
     */
    public EventUnfolding(Network network, List<String> compared, Budget budget) {
        this.budget = budget;
        this.network = network;
        this.wiring = new EventWiring(network, compared);
        this.parts = new EventReactions(network, wiring, budget);
        this.inputs = network.inputs().stream().map(Network.External::port).toList();
        this.firstLooks = wiring.firstLooks();
        this.registers = wiring.registers();
    }

    /** Why a network cannot be unfolded so; empty if it can. */
    public static Optional<String> obstacle(Network network) {
        Wiring wiring = new Wiring(network, List.of());
        for (Network.External input : network.inputs()) {
            boolean triggers =
                    wiring.readers.get(input.signal()).stream()
                            .anyMatch(reader -> !wiring.port(reader).latched());
            if (input.port().latched() && (triggers || EventWiring.isShown(network, input))) {
                return Optional.of(
                        "'%s' of %s keeps a value for its surroundings, but is an event inside"
                                .formatted(input.name(), network.component().qualifiedName()));
            }
        }
        return Optional.empty();
    }

    @Override
    public List<ComponentSemantics> behaviours() {
        return parts.behaviours();
    }

    @Override
    public int signal(int register) {
        Wiring.Reader reader = registers.get(register);
        return network.instances().get(reader.part()).inputSignals().get(reader.port());
    }

    @Override
    public boolean postpones() {
        return false;
    }

    @Override
    public Optional<String> leftOut() {
        return parts.leftOut();
    }

    /** The parts begin one after the other, and only then the first of them takes an event. */
    @Override
    public List<Unfolding.Step> beginnings() {
        return inOrder(new RunToCompletion(List.of(), nothingLatched()), parts::start);
    }

    /** What a part does when it is its turn, once. */
    private interface Turn {
        void take(RunToCompletion run, int part, Branches found);
    }

    /** The parts have their turn one after the other; then what they have caused is worked off. */
    private List<Unfolding.Step> inOrder(RunToCompletion beginning, Turn turn) {
        List<Unfolding.Step> outcomes = new ArrayList<>();
        List<RunToCompletion> runs = List.of(beginning);
        for (int part = 0; part < network.instances().size(); part++) {
            List<RunToCompletion> longer = new ArrayList<>();
            for (RunToCompletion run : runs) {
                turn.take(run, part, new Branches(longer, outcomes));
            }
            runs = longer;
        }
        complete(runs, null, outcomes);
        return outcomes;
    }

    private Value[][] nothingLatched() {
        return network.instances().stream()
                .map(instance -> new Value[instance.inputSignals().size()])
                .toArray(Value[][]::new);
    }

    /** Found by running: what a run looks at is known when it has looked. */
    @Override
    public InputAbstraction abstraction(GlobalState whole, Representatives standIns) {
        PortAbstraction[] looks = firstLooks.toArray(PortAbstraction[]::new);
        List<PortAbstraction> before;
        do {
            before = List.of(looks);
            for (Value[] letter :
                    standIns.letters(Component.Profile.EVENT_DRIVEN, inputs, before)) {
                run(whole, letter, looks);
            }
            standIns.copyWhatMeetsStrangers(looks);
        } while (!before.equals(Arrays.asList(looks)));
        return new InputAbstraction(before);
    }

    @Override
    public List<Unfolding.Step> reactions(GlobalState before, Value[] letter) {
        return run(before, letter, null);
    }

    private List<Unfolding.Step> run(
            GlobalState before, Value[] letter, PortAbstraction @Nullable [] looks) {
        RunToCompletion run = new RunToCompletion(before.parts(), latched(before, letter));
        boolean empty = true;
        for (int i = 0; i < letter.length; i++) {
            if (letter[i] != null && !inputs.get(i).latched()) {
                empty = false;
                int signal = network.inputs().get(i).signal();
                Optional<String> problem = parts.deliver(run, signal, List.of(letter[i]), i);
                if (problem.isPresent()) {
                    return List.of(Unfolding.Step.error(problem.get(), List.of()));
                }
            }
        }
        if (empty) {
            // No port is there for the event: as in an empty slice, each part is completed.
            return inOrder(run, parts::idle);
        }
        List<Unfolding.Step> outcomes = new ArrayList<>();
        complete(List.of(run), looks, outcomes);
        return outcomes;
    }

    private Value[][] latched(GlobalState before, Value[] letter) {
        Value[][] latched = nothingLatched();
        for (int part = 0; part < latched.length; part++) {
            for (int port = 0; port < latched[part].length; port++) {
                int input = wiring.held(part, port);
                latched[part][port] = input == EventWiring.INSIDE ? null : letter[input];
            }
        }
        for (int i = 0; i < registers.size(); i++) {
            List<Value> values = ((Sent.Messages) before.registers().get(i)).values();
            Wiring.Reader register = registers.get(i);
            latched[register.part()][register.port()] = values.isEmpty() ? null : values.get(0);
        }
        return latched;
    }

    /** Follows runs in all ways until every queue is empty, first alternatives first. */
    private void complete(
            List<RunToCompletion> runs,
            PortAbstraction @Nullable [] looks,
            List<Unfolding.Step> outcomes) {
        Deque<RunToCompletion> open = new ArrayDeque<>(runs);
        int reactions = 0;
        while (!open.isEmpty()) {
            budget.insist();
            RunToCompletion run = open.pop();
            if (run.isComplete()) {
                outcomes.add(outcome(run));
            } else if (run.length() > LONGEST) {
                parts.leaveOut("one event causes more than %d reactions".formatted(LONGEST));
            } else if (reactions > MOST_REACTIONS) {
                parts.leaveOut("what one event causes can go too many ways");
            } else if (!circles(run, outcomes)) {
                List<RunToCompletion> next = new ArrayList<>();
                parts.react(run, looks, new Branches(next, outcomes));
                reactions++;
                for (int i = next.size() - 1; i >= 0; i--) {
                    open.push(next.get(i));
                }
            }
        }
    }

    /**
     * Whether a run has come back to where it was, and so may go on for ever. Where it leaves the
     * circle, it has done so before; but if it sends something each time, not with as much sent.
     */
    private boolean circles(RunToCompletion run, List<Unfolding.Step> outcomes) {
        RunToCompletion earlier = run.circleBeginning();
        if (earlier == null) {
            return false;
        }
        outcomes.add(Unfolding.Step.error("messages circle without end", run.causes()));
        boolean shows =
                run.emissionsSince(earlier).stream()
                        .anyMatch(emission -> wiring.isObserved(emission.signal()));
        if (shows && run.hasAlternativesSince(earlier)) {
            parts.leaveOut("messages circle, as often as they like, and send more each time");
        }
        return true;
    }

    private Unfolding.Step outcome(RunToCompletion run) {
        List<Sent> kept = new ArrayList<>(registers.size());
        for (Wiring.Reader register : registers) {
            kept.add(Sent.of(run.latched(register.part(), register.port())));
        }
        List<List<Sent>> signals = new ArrayList<>();
        for (int signal = 0; signal < network.signals(); signal++) {
            signals.add(new ArrayList<>(1));
        }
        run.emissions().forEach(emission -> signals.get(emission.signal()).add(emission.sent()));
        List<Sent> sent = new ArrayList<>();
        for (Network.External output : network.outputs()) {
            sent.add(
                    output.signal() < 0
                            ? Sent.SILENCE
                            : parts.joined(output, signals.get(output.signal())));
        }
        return new Unfolding.Step(new GlobalState(run.parts(), kept), sent, run.causes());
    }
}
