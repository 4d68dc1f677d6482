package arcomat.analysis.search.composition;

import arcomat.analysis.search.Budget;
import arcomat.analysis.search.letter.Representatives;
import arcomat.model.Trace;
import arcomat.model.Value;
import arcomat.semantics.automaton.ComponentSemantics;
import arcomat.semantics.automaton.ComponentSemantics.JointError;
import arcomat.semantics.automaton.ComponentSemantics.JointReaction;
import arcomat.semantics.automaton.ComponentSemantics.JointStart;
import arcomat.semantics.automaton.ComponentSemantics.Prospect;
import arcomat.semantics.automaton.Configuration;
import arcomat.semantics.automaton.Input;
import arcomat.semantics.automaton.StepRelation;
import arcomat.semantics.expression.Sent;
import arcomat.semantics.network.Network;
import arcomat.semantics.value.InputAbstraction;
import arcomat.semantics.value.InputAbstraction.PortAbstraction;
import arcomat.semantics.value.InputAbstraction.Unseen;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;

/**
 * A time-synchronous network, slice by slice. The reaction to an input is what is visible in the
 * same slice on ports without delay, and in the next one on ports with delay.
 *
 * <p>The parts react one after the other. What a part leaves open is divided when somebody reads
 * it: into what the readers tell apart, or, where the outside sees the same message, into all its
 * values.
 */
public final class SliceUnfolding implements Unfolding {
    private final Network network;
    private final Wiring wiring;
    private final Budget budget;
    private final List<ComponentSemantics> behaviours;

    /** Whether a message has been divided a slice after it was sent. */
    private boolean postpones;

    /** One way through a slice of a composition, as far as its parts have reacted. */
    private static final class Slice {
        private final List<List<Configuration>> after;
        private final Sent[] visible;
        private final Sent[] registers;
        private final List<Trace.Cause> causes;

        /**
         * @param visible by signal, before any part has reacted
         */
        Slice(Sent[] visible, int signals) {
            this.after = new ArrayList<>();
            this.visible = visible;
            this.registers = new Sent[signals];
            this.causes = new ArrayList<>();
            Arrays.fill(registers, Sent.SILENCE);
        }

        private Slice(Slice other) {
            this.after = new ArrayList<>(other.after);
            this.visible = other.visible.clone();
            this.registers = other.registers.clone();
            this.causes = new ArrayList<>(other.causes);
        }

        /** Whether the part that has reacted last has ended the run. */
        boolean isOver() {
            return !after.isEmpty() && after.get(after.size() - 1).contains(Configuration.ERROR);
        }

        Slice copy() {
            return new Slice(this);
        }
    }

    public SliceUnfolding(Network network, List<String> compared, Budget budget) {
        this.network = network;
        this.wiring = new Wiring(network, compared);
        this.budget = budget;
        this.behaviours = ComponentSemantics.ofParts(network, budget::insist);
    }

    @Override
    public List<ComponentSemantics> behaviours() {
        return behaviours;
    }

    @Override
    public List<Unfolding.Step> beginnings() {
        return starts().stream().map(this::outcome).toList();
    }

    /** A message that passes through to the outside matters as a whole. */
    @Override
    public InputAbstraction abstraction(GlobalState whole, Representatives standIns) {
        PortAbstraction[] looks = new PortAbstraction[network.inputs().size()];
        for (int i = 0; i < looks.length; i++) {
            int signal = network.inputs().get(i).signal();
            looks[i] =
                    wiring.observed[signal]
                            ? new InputAbstraction.Copied()
                            : new InputAbstraction.Unseen();
            for (Wiring.Reader reader : wiring.readers.get(signal)) {
                looks[i] = looks[i].and(look(whole, reader.part(), reader.port()));
            }
        }
        return new InputAbstraction(List.of(looks));
    }

    @Override
    public List<Unfolding.Step> reactions(GlobalState before, Value[] letter) {
        return reactions(before, beginning(before, letter)).stream().map(this::outcome).toList();
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

    private Unfolding.Step outcome(Slice slice) {
        if (GlobalState.isError(slice.after)) {
            return Unfolding.Step.error("", slice.causes);
        }
        List<Sent> sent = new ArrayList<>();
        network.outputs().forEach(port -> sent.add(reaction(slice, port)));
        return new Unfolding.Step(
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
        return postpones;
    }

    @Override
    public Optional<String> leftOut() {
        return Optional.empty();
    }

    /** The beginnings of all parts at once. */
    private List<Slice> starts() {
        List<Slice> slices = List.of(new Slice(wiring.silence(), wiring.delayed.length));
        for (int part = 0; part < behaviours.size(); part++) {
            List<Slice> longer = new ArrayList<>();
            for (Slice slice : slices) {
                for (JointStart start : behaviours.get(part).starts(budget::insist)) {
                    Slice copy = slice.copy();
                    copy.after.add(start.configurations());
                    send(copy, part, start.output().ports(), longer);
                }
            }
            slices = longer;
        }
        return slices;
    }

    /** All ways through a slice. */
    private List<Slice> reactions(GlobalState before, Slice beginning) {
        List<Slice> slices = List.of(beginning);
        for (int part = 0; part < behaviours.size(); part++) {
            List<Slice> longer = new ArrayList<>();
            for (Slice slice : slices) {
                if (slice.isOver()) {
                    longer.add(slice);
                    continue;
                }
                for (Slice settled : settled(slice, before, part)) {
                    react(settled, before, part, longer);
                }
            }
            slices = longer;
        }
        return slices;
    }

    /** Slices in which all that a part looks at is certain. */
    private List<Slice> settled(Slice slice, GlobalState before, int part) {
        List<Slice> settled = List.of(slice);
        List<Integer> signals = network.instances().get(part).inputSignals();
        for (int i = 0; i < signals.size(); i++) {
            int signal = signals.get(i);
            if (signal == Network.UNCONNECTED
                    || slice.visible[signal] instanceof Sent.Messages
                    || look(before, part, i) instanceof Unseen) {
                continue;
            }
            List<Slice> divided = new ArrayList<>();
            List<Sent> samples = samples(signal, slice.visible[signal], before);
            postpones |= wiring.delayed[signal] && samples.size() > 1;
            for (Slice each : settled) {
                for (Sent sent : samples) {
                    budget.insist();
                    Slice copy = each.copy();
                    copy.visible[signal] = sent;
                    divided.add(copy);
                }
            }
            settled = divided;
        }
        return settled;
    }

    private List<Sent> samples(int signal, Sent open, GlobalState before) {
        PortAbstraction look = new Unseen();
        for (Wiring.Reader reader : wiring.readers.get(signal)) {
            look = look.and(look(before, reader.part(), reader.port()));
        }
        return wiring.samples(signal, !open.allows(List.of()), look);
    }

    /** What a part looks at, in the configuration before the slice. */
    private PortAbstraction look(GlobalState before, int part, int port) {
        PortAbstraction look = new Unseen();
        List<Configuration> configurations = before.parts().get(part);
        List<StepRelation> relations = behaviours.get(part).relations();
        for (int i = 0; i < configurations.size(); i++) {
            look = look.and(relations.get(i).abstraction(configurations.get(i)).looks().get(port));
        }
        return look;
    }

    private void react(Slice slice, GlobalState before, int part, List<Slice> next) {
        Prospect prospect =
                behaviours
                        .get(part)
                        .prospect(
                                before.parts().get(part),
                                Input.of(
                                        network.instances().get(part).inputSignals(),
                                        slice.visible),
                                budget::insist);
        for (JointError error : prospect.errors()) {
            Slice copy = slice.copy();
            copy.after.add(List.of(Configuration.ERROR));
            copy.causes.addAll(error.causes());
            next.add(copy);
        }
        for (JointReaction reaction : prospect.reactions()) {
            Slice copy = slice.copy();
            copy.after.add(reaction.next());
            reaction.reactions().forEach(r -> copy.causes.add(r.cause()));
            send(copy, part, reaction.output().ports(), next);
        }
    }

    /**
     * Puts what a part sends on its signals. A message that is left open, and that the outside will
     * see and somebody else too, has to be the same for both: it is divided here.
     */
    private void send(Slice slice, int part, List<Sent> sent, List<Slice> found) {
        List<Slice> slices = List.of(slice);
        List<Integer> signals = network.instances().get(part).outputSignals();
        for (int i = 0; i < sent.size(); i++) {
            int signal = signals.get(i);
            List<Slice> longer = new ArrayList<>();
            for (Slice each : slices) {
                for (Sent option : options(signal, sent.get(i))) {
                    budget.insist();
                    Slice copy = each.copy();
                    (wiring.delayed[signal] ? copy.registers : copy.visible)[signal] = option;
                    longer.add(copy);
                }
            }
            slices = longer;
        }
        found.addAll(slices);
    }

    private List<Sent> options(int signal, Sent sent) {
        if (sent instanceof Sent.Messages || !wiring.shared[signal]) {
            return List.of(sent);
        }
        return wiring.samples(signal, !sent.allows(List.of()), new InputAbstraction.Whole());
    }
}
