package arcomat.simulate.test;

import arcomat.model.StreamTest;
import arcomat.model.Value;
import arcomat.semantics.expression.Sent;
import arcomat.semantics.network.Network;
import arcomat.semantics.value.InputAbstraction;
import arcomat.simulate.run.Events;

import org.jspecify.annotations.Nullable;

import java.util.ArrayList;
import java.util.Collection;
import java.util.List;
import java.util.Optional;

/**
 * Where messages go in an event-driven network: into queues, to latched ports, and to the outside,
 * where a test compares them with what it expects.
 */
final class Posts {
    /** Of messages that only parts receive, and of which any number may be sent, as many. */
    private static final int MOST_AT_ONCE = 2;

    private static final int MOST_OPTIONS = 100;

    /** An output that the test looks at. */
    private record Stream(int number, List<Value> expected) {}

    private final Network network;
    private final Collection<Value> mentioned;
    private final Wires wires;
    private final List<List<Stream>> streams = new ArrayList<>();
    private final List<Stream> all = new ArrayList<>();
    private @Nullable String problem;
    private @Nullable String untried;

    Posts(Network network, StreamTest test, Collection<Value> mentioned) {
        this.network = network;
        this.mentioned = mentioned;
        this.wires = new Wires(network);
        for (int signal = 0; signal < network.signals(); signal++) {
            streams.add(new ArrayList<>(1));
        }
        for (Network.External external : network.outputs()) {
            if (test.expected().containsKey(external.name())) {
                List<Value> expected =
                        test.expected().get(external.name()).stream()
                                .flatMap(List::stream)
                                .toList();
                Stream stream = new Stream(all.size(), expected);
                all.add(stream);
                if (external.signal() != Network.UNCONNECTED) {
                    streams.get(external.signal()).add(stream);
                }
            }
        }
    }

    int streams() {
        return all.size();
    }

    boolean isComplete(PossibleRun run) {
        return all.stream().allMatch(each -> run.seen[each.number] == each.expected.size());
    }

    /** Whether anybody takes notice of a signal. */
    boolean isOfUse(int signal) {
        return !wires.readers(signal).isEmpty() || !streams.get(signal).isEmpty();
    }

    /** Why a message could not be sent, if it was not that the test expects another. */
    Optional<String> problem() {
        return Optional.ofNullable(problem);
    }

    void forgetProblem() {
        problem = null;
    }

    /** Why not all was tried that is left open. */
    Optional<String> untried() {
        return Optional.ofNullable(untried);
    }

    boolean send(PossibleRun run, int signal, List<Value> messages) {
        return messages.stream().allMatch(message -> send(run, signal, message));
    }

    /** False where the test expects something else, or a queue is full. */
    boolean send(PossibleRun run, int signal, Value message) {
        for (Stream stream : streams.get(signal)) {
            int position = run.seen[stream.number]++;
            if (position >= stream.expected.size()
                    || !stream.expected.get(position).equals(message)) {
                return false;
            }
        }
        for (Wires.Reader receiver : wires.readers(signal)) {
            Network.Instance instance = network.instances().get(receiver.instance());
            if (receiver.latched()) {
                run.latch(receiver.instance(), receiver.port(), message);
            } else if (run.waiting(receiver.instance()) < instance.component().queueCapacity()) {
                run.enqueue(receiver.instance(), new PossibleRun.Event(receiver.port(), message));
            } else {
                String port = instance.component().inputs().get(receiver.port()).name();
                problem = Events.fullQueue(instance, port).getMessage();
                return false;
            }
        }
        return true;
    }

    /** What may be sent on a signal: the messages themselves, or some of what is left open. */
    List<List<Value>> options(PossibleRun run, int signal, Sent sent) {
        if (sent instanceof Sent.Messages messages) {
            return List.of(messages.values());
        }
        if (!streams.get(signal).isEmpty()) {
            return expected(run, signal, sent);
        }
        return isOfUse(signal) ? inside(signal, sent) : List.of(List.of());
    }

    /** The next messages that the test expects, each number of them. */
    private List<List<Value>> expected(PossibleRun run, int signal, Sent sent) {
        Stream stream = streams.get(signal).get(0);
        int from = Math.min(run.seen[stream.number], stream.expected.size());
        List<List<Value>> options = new ArrayList<>();
        for (int to = from; to <= stream.expected.size(); to++) {
            List<Value> messages = stream.expected.subList(from, to);
            if (sent.allows(messages)
                    && messages.stream().allMatch(v -> wires.port(signal).type().has(v))) {
                options.add(messages);
            }
        }
        return options;
    }

    private List<List<Value>> inside(int signal, Sent sent) {
        Division.Options each =
                Division.values(wires.port(signal), true, new InputAbstraction.Whole(), mentioned);
        boolean complete = each.complete();
        boolean one = !sent.allows(List.of());
        boolean held = wires.readers(signal).stream().allMatch(Wires.Reader::latched);
        List<List<Value>> options = new ArrayList<>();
        List<List<Value>> longest = List.of(List.of());
        if (!one) {
            options.add(List.of());
        }
        for (int length = 1; length <= (one || held ? 1 : MOST_AT_ONCE); length++) {
            List<List<Value>> longer = new ArrayList<>();
            for (List<Value> messages : longest) {
                for (Sent sample : each.samples()) {
                    List<Value> more = new ArrayList<>(messages);
                    more.addAll(((Sent.Messages) sample).values());
                    longer.add(more);
                }
            }
            if (length > 1 && longer.size() > MOST_OPTIONS) {
                break;
            }
            options.addAll(longer);
            longest = longer;
        }
        if (!complete || !one && !held) {
            untried =
                    "not everything that the model leaves open on port '"
                            + wires.port(signal).name()
                            + "' inside was tried";
        }
        return options;
    }
}
