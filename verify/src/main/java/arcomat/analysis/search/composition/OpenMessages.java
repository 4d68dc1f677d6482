package arcomat.analysis.search.composition;

import arcomat.analysis.search.Budget;
import arcomat.analysis.search.step.CubeSplit;
import arcomat.model.Value;
import arcomat.semantics.expression.Sent;
import arcomat.semantics.network.Network;
import arcomat.semantics.value.InputAbstraction;

import java.util.ArrayList;
import java.util.List;
import java.util.function.Consumer;

/**
 * What becomes of messages that event-driven parts leave open: one that a part will read is divided
 * into all its values, one that only the outside sees stays open.
 */
public final class OpenMessages {
    private final Network network;
    private final EventWiring wiring;
    private final Budget budget;
    private final Consumer<String> leaveOut;

    /**
     * @param leaveOut told why some messages that may be sent are left out
     */
    public OpenMessages(
            Network network, EventWiring wiring, Budget budget, Consumer<String> leaveOut) {
        this.network = network;
        this.wiring = wiring;
        this.budget = budget;
        this.leaveOut = leaveOut;
    }

    /**
     * All ways to settle what somebody reads of an output; the rest stays open.
     *
     * @param output by output port of the part
     */
    public List<List<Sent>> settled(int part, List<Sent> output) {
        List<List<Sent>> options = new ArrayList<>();
        for (int i = 0; i < output.size(); i++) {
            options.add(options(part, i, output.get(i)));
        }
        return CubeSplit.combinations(options, budget);
    }

    private List<Sent> options(int part, int output, Sent sent) {
        int signal = network.instances().get(part).outputSignals().get(output);
        List<Wiring.Reader> readers = wiring.readers(signal);
        if (sent instanceof Sent.Messages || readers.isEmpty() && !isShared(signal)) {
            return List.of(sent);
        }
        boolean all = sent instanceof Sent.AnyMessage;
        if (!all && (wiring.isObserved(signal) || !readers.stream().allMatch(wiring::isLatched))) {
            leaveOut.accept(
                    "%s leaves open what it sends on '%s', %s; %s"
                            .formatted(
                                    wiring.path(part),
                                    wiring.wiring().sender[signal].name(),
                                    readers.isEmpty()
                                            ? "and two ports show it"
                                            : "and parts read it",
                                    "decide with transitions, or with another completion"));
            return List.of(Sent.SILENCE);
        }
        return wiring.wiring().samples(signal, all, new InputAbstraction.Whole());
    }

    private boolean isShared(int signal) {
        return wiring.wiring().shared[signal];
    }

    /**
     * What is sent on a port one after the other, as one.
     *
     * @param all on its signal, in order
     */
    public Sent joined(Network.External output, List<Sent> all) {
        if (all.size() == 1) {
            return all.get(0);
        }
        if (!all.isEmpty() && all.stream().allMatch(Sent.Anything.class::isInstance)) {
            return all.get(0);
        }
        List<Value> messages = new ArrayList<>();
        for (Sent each : all) {
            if (each instanceof Sent.Messages closed) {
                messages.addAll(closed.values());
            } else {
                if (wiring.isObserved(output.signal())) {
                    leaveOut.accept(
                            "'%s' carries messages that are left open beside others"
                                    .formatted(output.name()));
                }
                if (each instanceof Sent.AnyMessage) {
                    messages.add(output.port().type().first());
                }
            }
        }
        return new Sent.Messages(messages);
    }
}
