package arcomat.check;

import arcomat.symbols.AutomatonSymbol;
import arcomat.symbols.InitialSymbol;
import arcomat.symbols.StateSymbol;
import arcomat.symbols.TransitionSymbol;

import java.util.ArrayDeque;
import java.util.Deque;
import java.util.HashSet;
import java.util.List;
import java.util.Set;

/**
 * ARC1003: transitions lead from an initial state to each state, whatever their guards say. What
 * guards have to do with it, the analysis of that code knows, which says all that this law says.
 */
final class StateReached implements Check.OnAutomaton {

    @Override
    public Law law() {
        return Law.warning("ARC1003").needing(Law.Needs.ALL);
    }

    @Override
    public void check(AutomatonSymbol automaton, Context context, Findings findings) {
        if (!Automata.isExamined(automaton) || !isWhole(automaton)) {
            return;
        }
        Set<StateSymbol> reached = reached(automaton);
        for (StateSymbol state : automaton.states()) {
            if (!reached.contains(state)) {
                report(automaton, state, findings);
            }
        }
    }

    static boolean isWhole(AutomatonSymbol automaton) {
        return !automaton.initials().isEmpty()
                && StateNames.declared(automaton).size() == automaton.states().size()
                && automaton.initials().stream().allMatch(each -> each.state().isPresent())
                && automaton.transitions().stream()
                        .allMatch(t -> t.source().isPresent() && t.target().isPresent());
    }

    private static Set<StateSymbol> reached(AutomatonSymbol automaton) {
        Set<StateSymbol> reached = new HashSet<>();
        Deque<StateSymbol> open = new ArrayDeque<>();
        for (InitialSymbol initial : automaton.initials()) {
            open.add(initial.state().orElseThrow());
        }
        while (!open.isEmpty()) {
            StateSymbol state = open.pop();
            if (reached.add(state)) {
                for (TransitionSymbol each : automaton.transitions()) {
                    if (each.source().orElseThrow().equals(state)) {
                        open.add(each.target().orElseThrow());
                    }
                }
            }
        }
        return reached;
    }

    private static void report(AutomatonSymbol automaton, StateSymbol state, Findings findings) {
        List<TransitionSymbol> leading =
                automaton.transitions().stream()
                        .filter(t -> t.target().orElseThrow().equals(state))
                        .filter(t -> !t.source().orElseThrow().equals(state))
                        .toList();
        findings.report(
                state.node().name(),
                "state %s is never reached: %s"
                        .formatted(
                                state.name(),
                                leading.isEmpty()
                                        ? "no transition leads to it"
                                        : "no run carries out a transition that leads to it"));
        leading.forEach(each -> findings.related(each.node(), "leads to it"));
    }
}
