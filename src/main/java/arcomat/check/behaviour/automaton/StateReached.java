package arcomat.check.behaviour.automaton;

import arcomat.check.law.Check;
import arcomat.symbols.bodies.AutomatonSymbol;
import arcomat.symbols.bodies.AutomatonSymbol.StateSymbol;
import arcomat.symbols.bodies.TransitionSymbol;

import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.BitSet;
import java.util.Deque;
import java.util.List;
import java.util.function.Predicate;

/**
 * ARC1003: transitions lead from an initial state to each state, whatever their guards say. What
 * guards have to do with it, the analysis of that code knows, which says all that this law says.
 */
public final class StateReached implements Check.OnAutomaton {

    @Override
    public void check(AutomatonSymbol automaton, Context context, Findings findings) {
        if (!Automata.isExamined(automaton) || !isWhole(automaton)) {
            return;
        }
        List<StateSymbol> starts =
                automaton.initials().stream().map(each -> each.state().orElseThrow()).toList();
        BitSet reached = reached(starts, outgoing(automaton), transition -> true);
        for (StateSymbol state : automaton.states()) {
            boolean isFirst = automaton.state(state.name()).orElseThrow().index() == state.index();
            if (isFirst && !reached.get(state.index())) {
                report(automaton, state, findings);
            }
        }
    }

    static boolean isWhole(AutomatonSymbol automaton) {
        return !automaton.initials().isEmpty()
                && automaton.initials().stream().allMatch(each -> each.state().isPresent())
                && automaton.transitions().stream()
                        .allMatch(each -> each.source().isPresent() && each.target().isPresent());
    }

    /**
     * The states that some transitions lead to, by their index.
     *
     * @param outgoing as {@link #outgoing} has them
     */
    static BitSet reached(
            List<StateSymbol> starts,
            List<List<TransitionSymbol>> outgoing,
            Predicate<TransitionSymbol> some) {
        BitSet reached = new BitSet();
        Deque<StateSymbol> open = new ArrayDeque<>(starts);
        while (!open.isEmpty()) {
            int state = open.pop().index();
            if (!reached.get(state)) {
                reached.set(state);
                outgoing.get(state).stream()
                        .filter(some)
                        .forEach(each -> open.add(each.target().orElseThrow()));
            }
        }
        return reached;
    }

    /** The transitions out of each state, by its index, in text order. */
    static List<List<TransitionSymbol>> outgoing(AutomatonSymbol automaton) {
        List<List<TransitionSymbol>> outgoing = new ArrayList<>();
        for (int state = 0; state < automaton.states().size(); state++) {
            outgoing.add(new ArrayList<>());
        }
        for (TransitionSymbol each : automaton.transitions()) {
            outgoing.get(each.source().orElseThrow().index()).add(each);
        }
        return outgoing;
    }

    private static void report(AutomatonSymbol automaton, StateSymbol state, Findings findings) {
        List<TransitionSymbol> leading =
                automaton.transitions().stream()
                        .filter(t -> t.target().orElseThrow().equals(state))
                        .filter(t -> !t.source().orElseThrow().equals(state))
                        .toList();
        findings.report(
                state.node().name(),
                "state %s is never reached: %s",
                state.name(),
                leading.isEmpty()
                        ? "no transition leads to it"
                        : "no run carries out a transition that leads to it");
        leading.forEach(each -> findings.related(each.node(), "leads to it"));
    }
}
