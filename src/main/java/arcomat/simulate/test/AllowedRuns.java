package arcomat.simulate.test;

import arcomat.model.Letter;
import arcomat.model.Port;
import arcomat.model.Value;
import arcomat.semantics.automaton.ComponentSemantics.JointReaction;
import arcomat.semantics.automaton.ComponentSemantics.JointStart;
import arcomat.semantics.automaton.ComponentSemantics.Prospect;
import arcomat.semantics.automaton.Configuration;
import arcomat.semantics.automaton.Input;
import arcomat.semantics.expression.Sent;
import arcomat.semantics.network.Network;
import arcomat.simulate.test.Possibility.NetworkState;

import org.jspecify.annotations.Nullable;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.Collection;
import java.util.Comparator;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.Optional;

/**
 * All runs of a time-synchronous network at once, as a set of worlds (subset construction). What a
 * completion leaves open stays open until the test expects something there, or somebody reads it;
 * then it is decided, once for all who receive it. Where too much would have to be tried, some of
 * it is, and what is not tried is remembered: an instance that might have read anything is in chaos
 * from there on, a loose run that shows at most that nobody knows.
 */
final class AllowedRuns extends AllowedBehaviour {
    /** More worlds than that are not followed. */
    static final int MOST_WORLDS = 10_000;

    /** Of those, as many. */
    private static final int FOLLOWED = 1_000;

    private final Wires wires;
    private final Division division;
    private @Nullable String tooMany;
    private @Nullable String untried;

    /**
     * @param mentioned values that may matter where not all can be tried
     */
    AllowedRuns(Network network, Collection<Value> mentioned) {
        super(network);
        wires = new Wires(network);
        division = new Division(wires, behaviours, mentioned);
    }

    Wires wires() {
        return wires;
    }

    /** Why not all runs were followed; empty if they were. */
    Optional<String> tooMany() {
        return Optional.ofNullable(tooMany);
    }

    /** What promises nothing any more where runs are allowed only for that reason, in words. */
    String chaotic(List<Possibility> possible) {
        return possible.stream()
                .filter(each -> each.chaotic >= 0)
                .findFirst()
                .map(each -> chaos(network, each.chaotic, each.configurations))
                .orElse(chaosSomewhere(network));
    }

    /** What a loose run is about. */
    String untried() {
        return Objects.requireNonNull(untried);
    }

    /** Between two slices, with what each world stands for. */
    Map<NetworkState, Standing> starts() {
        Sent[] silent = new Sent[network.signals()];
        Arrays.fill(silent, Sent.SILENCE);
        NetworkState nothing = new NetworkState(List.of(), List.of(silent));
        List<Possibility> possible = List.of(new Possibility(nothing, Standing.SURE));
        for (int i = 0; i < behaviours.size(); i++) {
            List<Possibility> next = new ArrayList<>();
            for (Possibility before : possible) {
                for (JointStart start : behaviours.get(i).starts()) {
                    Possibility after = before.copy();
                    after.configurations.add(start.configurations());
                    send(after, i, start.output().ports(), Expected.NOTHING);
                    next.add(after);
                }
            }
            possible = limited(next);
        }
        return worlds(possible);
    }

    /** All ways through a slice that show what is expected. */
    List<Possibility> slice(Map<NetworkState, Standing> worlds, Letter letter, Expected expected) {
        lastProblem = null;
        List<Possibility> possible = new ArrayList<>();
        for (Possibility possibility : beginnings(worlds)) {
            for (Network.External external : network.inputs()) {
                List<Value> messages = letter.messages(external.name());
                possibility.visible[external.signal()] = new Sent.Messages(messages);
            }
            if (shows(possibility, expected)) {
                possible.add(possibility);
            }
        }
        for (int i = 0; i < behaviours.size(); i++) {
            List<Possibility> next = new ArrayList<>(possible.size());
            for (Possibility possibility : possible) {
                for (Possibility settled : settled(possibility, i)) {
                    react(settled, i, expected, next);
                }
                next = roomy(next);
            }
            possible = limited(next);
        }
        return possible;
    }

    /** What is visible in a slice before anything reacts in it, where that is as expected. */
    List<Possibility> registers(Map<NetworkState, Standing> worlds, Expected expected) {
        List<Possibility> possible = beginnings(worlds);
        possible.removeIf(possibility -> !shows(possibility, expected));
        return possible;
    }

    private static List<Possibility> beginnings(Map<NetworkState, Standing> worlds) {
        List<Possibility> possible = new ArrayList<>();
        worlds.forEach((world, standing) -> possible.add(new Possibility(world, standing)));
        return possible;
    }

    /** Possibilities that are the same from here on are one world, which stands for the best. */
    static Map<NetworkState, Standing> worlds(List<Possibility> possible) {
        Map<NetworkState, Standing> worlds = new LinkedHashMap<>();
        for (Possibility each : possible) {
            worlds.merge(
                    each.finish(), each.standing, (one, two) -> one.isBetterThan(two) ? one : two);
        }
        return worlds;
    }

    private List<Possibility> limited(List<Possibility> possible) {
        if (possible.size() <= MOST_WORLDS) {
            return possible;
        }
        Map<Object, Possibility> different = new LinkedHashMap<>();
        for (Possibility each : possible) {
            different.merge(
                    each.state(),
                    each,
                    (one, two) -> two.standing.isBetterThan(one.standing) ? two : one);
        }
        if (different.size() <= MOST_WORLDS) {
            return new ArrayList<>(different.values());
        }
        tooMany = "more than " + MOST_WORLDS + " possible runs: the test leaves too much open";
        List<Possibility> best = new ArrayList<>(different.values());
        best.sort(Comparator.comparing(each -> each.standing));
        return spread(best);
    }

    /** Some of many, those at the beginning like those at the end. */
    private static List<Possibility> spread(List<Possibility> many) {
        List<Possibility> some = new ArrayList<>(FOLLOWED);
        for (int i = 0; i < FOLLOWED; i++) {
            some.add(many.get((int) ((long) i * many.size() / FOLLOWED)));
        }
        return some;
    }

    /** Keeps a list from growing without end while it is made. */
    private List<Possibility> roomy(List<Possibility> growing) {
        return growing.size() > 2 * MOST_WORLDS ? new ArrayList<>(limited(growing)) : growing;
    }

    /** Possibilities in which all that an instance looks at is certain, where that can be had. */
    private List<Possibility> settled(Possibility possibility, int instance) {
        List<Possibility> settled = List.of(possibility);
        List<Integer> signals = network.instances().get(instance).inputSignals();
        for (int port = 0; port < signals.size(); port++) {
            int signal = signals.get(port);
            if (signal != Network.UNCONNECTED
                    && isOpen(possibility, signal)
                    && division.isSeen(possibility, instance, port)) {
                List<Possibility> divided = new ArrayList<>();
                for (Possibility each : settled) {
                    divide(each, instance, signal, divided);
                    divided = roomy(divided);
                }
                settled = divided;
            }
        }
        return settled;
    }

    private void divide(Possibility open, int instance, int signal, List<Possibility> divided) {
        if (!isOpen(open, signal) || isLost(open, instance)) {
            divided.add(open);
            return;
        }
        Division.Options options = division.of(open, signal);
        for (Sent sample : options.samples()) {
            Possibility copy = open.copy();
            decide(copy, signal, sample);
            divided.add(copy);
        }
        if (!options.complete()) {
            divided.add(lost(open, instance, signal));
        }
    }

    private static boolean isOpen(Possibility possibility, int signal) {
        return !(possibility.visible[signal] instanceof Sent.Messages);
    }

    private static boolean isLost(Possibility possibility, int instance) {
        return possibility.configurations.get(instance).stream()
                .allMatch(configuration -> configuration == Configuration.CHAOS);
    }

    /** What an instance does that reads a message of which nobody knows what it is. */
    private Possibility lost(Possibility open, int instance, int signal) {
        Possibility copy = open.copy();
        copy.standing = Standing.LOOSE;
        List<Configuration> before = copy.configurations.get(instance);
        copy.configurations.set(instance, before.stream().map(c -> Configuration.CHAOS).toList());
        untried =
                "not every value that the model leaves open on "
                        + wires.name(signal)
                        + " was tried: it matters which, and "
                        + wires.port(signal).type().name()
                        + " has too many";
        return copy;
    }

    private void decide(Possibility possibility, int signal, Sent sent) {
        if (isOpen(possibility, signal)
                && sent instanceof Sent.Messages
                && isFromChaos(possibility, signal)) {
            possibility.standing = possibility.standing.and(Standing.VACUOUS);
            boolean known = possibility.chaotic >= 0;
            possibility.chaotic = known ? possibility.chaotic : wires.sender(signal).getAsInt();
        }
        possibility.visible[signal] = sent;
    }

    private void react(
            Possibility before, int instance, Expected expected, List<Possibility> next) {
        List<Integer> signals = network.instances().get(instance).inputSignals();
        Input input = Input.of(signals, before.visible);
        Prospect prospect = prospect(instance, before.configurations.get(instance), input);
        for (JointReaction reaction : prospect.reactions()) {
            Possibility after = before.copy();
            after.configurations.set(instance, reaction.next());
            if (send(after, instance, reaction.output().ports(), expected)) {
                next.add(after);
            }
        }
    }

    /** Puts messages on their signals; false where those without delay are not as expected. */
    private boolean send(Possibility after, int instance, List<Sent> sent, Expected expected) {
        List<Integer> signals = network.instances().get(instance).outputSignals();
        for (int i = 0; i < sent.size(); i++) {
            int signal = signals.get(i);
            if (!wires.isOfUse(signal)) {
                continue;
            }
            if (wires.isDelayed(signal)) {
                after.registers[signal] = sent.get(i);
            } else {
                after.visible[signal] = sent.get(i);
                if (!shows(after, signal, expected)) {
                    return false;
                }
            }
        }
        return true;
    }

    /** Whether what is known before a slice is as expected: registers, and what is read. */
    private boolean shows(Possibility beginning, Expected expected) {
        for (int signal = 0; signal < network.signals(); signal++) {
            boolean known = wires.isDelayed(signal) || wires.sender(signal).isEmpty();
            if (known && !shows(beginning, signal, expected)) {
                return false;
            }
        }
        return shows(beginning, Network.UNCONNECTED, expected);
    }

    /** Whether a signal is as expected; what is open is then decided, for all who receive it. */
    boolean shows(Possibility possibility, int signal, Expected expected) {
        Port sender = signal == Network.UNCONNECTED ? null : wires.port(signal);
        Optional<Sent> left = expected.settle(signal, seen(possibility, signal), sender);
        if (left.isPresent() && signal != Network.UNCONNECTED) {
            decide(possibility, signal, left.get());
        }
        return left.isPresent();
    }

    /** What is seen on the signal of an external output. */
    static Sent seen(Possibility possibility, int signal) {
        return signal == Network.UNCONNECTED ? Sent.SILENCE : possibility.visible[signal];
    }

    private boolean isFromChaos(Possibility possibility, int signal) {
        return wires.sender(signal).isPresent()
                && possibility.isChaotic(wires.sender(signal).getAsInt(), wires.isDelayed(signal));
    }
}
