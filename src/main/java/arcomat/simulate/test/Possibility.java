package arcomat.simulate.test;

import arcomat.semantics.automaton.Configuration;
import arcomat.semantics.expression.Sent;
import arcomat.simulate.test.AllowedBehaviour.Standing;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;

/** A world in the middle of a slice: some instances have reacted, the others have yet to. */
final class Possibility {
    final Sent[] visible;
    final Sent[] registers;
    final List<List<Configuration>> configurations;
    private final List<List<Configuration>> before;
    Standing standing;

    /**
     * The first instance that allows, from chaos, what is decided in this slice; -1 if none does.
     */
    int chaotic = -1;

    Possibility(NetworkState world, Standing standing) {
        this.standing = standing;
        before = world.configurations();
        visible = world.registers().toArray(new Sent[0]);
        registers = new Sent[visible.length];
        Arrays.fill(registers, Sent.SILENCE);
        configurations = new ArrayList<>(world.configurations());
    }

    private Possibility(Possibility other) {
        visible = other.visible.clone();
        registers = other.registers.clone();
        configurations = new ArrayList<>(other.configurations);
        before = other.before;
        standing = other.standing;
        chaotic = other.chaotic;
    }

    Possibility copy() {
        return new Possibility(this);
    }

    /** Where the automata of an instance were when the slice began. */
    List<Configuration> before(int instance) {
        return before.get(instance);
    }

    /**
     * Whether an instance promises nothing about the messages that it shows in this slice.
     *
     * @param delayed whether it has sent them a slice ago
     */
    boolean isChaotic(int instance, boolean delayed) {
        List<Configuration> sender = (delayed ? before : configurations).get(instance);
        return AllowedBehaviour.isChaotic(sender);
    }

    NetworkState finish() {
        return new NetworkState(List.copyOf(configurations), List.of(registers));
    }

    /** All that matters for the rest of the slice, to find possibilities that are the same. */
    List<Object> state() {
        return List.of(List.copyOf(configurations), List.of(registers), List.of(visible), before);
    }

    /**
     * A state of a network between two slices.
     *
     * @param configurations per instance, per automaton
     * @param registers per signal what its next slice shows; silence for a signal without a
     *     register
     */
    record NetworkState(List<List<Configuration>> configurations, List<Sent> registers) {}
}
