package arcomat.analysis.search.composition;

import arcomat.model.Trace;
import arcomat.semantics.automaton.Configuration;
import arcomat.semantics.expression.Sent;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;

/** One way through a slice of a composition, as far as its parts have reacted. */
final class Slice {
    final List<List<Configuration>> after;
    final Sent[] visible;
    final Sent[] registers;
    final List<Trace.Cause> causes;

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
