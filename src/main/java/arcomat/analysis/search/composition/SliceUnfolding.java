package arcomat.analysis.search.composition;

import arcomat.analysis.search.Budget;
import arcomat.analysis.search.letter.Representatives;
import arcomat.model.Value;
import arcomat.semantics.automaton.Behaviour;
import arcomat.semantics.expression.Sent;
import arcomat.semantics.network.Network;
import arcomat.semantics.value.Attention;
import arcomat.semantics.value.Attention.Look;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;

/**
 * A time-synchronous network, slice by slice. The reaction to an input is what is visible in the
 * same slice on ports without delay, and in the next one on ports with delay.
 */
public final class SliceUnfolding implements Unfolding {
    private final Network network;
    private final Wiring wiring;
    private final SliceReactions parts;

    public SliceUnfolding(Network network, List<String> compared, Budget budget) {
        this.network = network;
        this.wiring = new Wiring(network, compared);
        this.parts = new SliceReactions(network, wiring, budget);
    }

    @Override
    public List<Behaviour> behaviours() {
        return parts.behaviours();
    }

    @Override
    public List<GlobalStep> beginnings() {
        return parts.starts().stream().map(this::outcome).toList();
    }

    /** A message that passes through to the outside matters as a whole. */
    @Override
    public Attention attention(GlobalState whole, Representatives standIns) {
        Look[] looks = new Look[network.inputs().size()];
        for (int i = 0; i < looks.length; i++) {
            int signal = network.inputs().get(i).signal();
            looks[i] = wiring.observed[signal] ? new Attention.Copied() : new Attention.Unseen();
            for (Wiring.Reader reader : wiring.readers.get(signal)) {
                looks[i] = looks[i].and(parts.look(whole, reader.part(), reader.port()));
            }
        }
        return new Attention(List.of(looks));
    }

    @Override
    public List<GlobalStep> reactions(GlobalState before, Value[] letter) {
        return parts.reactions(before, beginning(before, letter)).stream()
                .map(this::outcome)
                .toList();
    }

    private Slice beginning(GlobalState before, Value[] letter) {
        Sent[] visible = wiring.silence();
        for (int signal = 0; signal < visible.length; signal++) {
            visible[signal] = before.registers().get(signal);
        }
        for (int i = 0; i < letter.length; i++) {
            visible[network.inputs().get(i).signal()] = Sent.of(letter[i]);
        }
        return new Slice(visible, visible.length);
    }

    private GlobalStep outcome(Slice slice) {
        if (GlobalState.isError(slice.after)) {
            return GlobalStep.error("", slice.causes);
        }
        List<Sent> sent = new ArrayList<>();
        network.outputs().forEach(port -> sent.add(reaction(slice, port)));
        return new GlobalStep(
                new GlobalState(slice.after, List.of(slice.registers)), sent, slice.causes);
    }

    private Sent reaction(Slice slice, Network.External port) {
        if (port.signal() == Network.UNCONNECTED) {
            return Sent.SILENCE;
        }
        return wiring.delayed[port.signal()]
                ? slice.registers[port.signal()]
                : slice.visible[port.signal()];
    }

    @Override
    public int signal(int register) {
        return register;
    }

    @Override
    public boolean postpones() {
        return parts.postpone();
    }

    @Override
    public Optional<String> leftOut() {
        return Optional.empty();
    }
}
