package arcomat.check.behaviour.automaton;

import arcomat.check.law.Check;
import arcomat.symbols.bodies.AutomatonSymbol;
import arcomat.symbols.bodies.AutomatonSymbol.StateSymbol;
import arcomat.symbols.bodies.ItemSymbol;
import arcomat.symbols.bodies.TransitionSymbol;
import arcomat.symbols.expressions.ItemValue;

import java.util.BitSet;
import java.util.List;
import java.util.Optional;
import java.util.Set;

/**
 * ARC1001: in what is to run and leaves nothing else open, no two transitions without guards answer
 * one letter. A requirement may leave that open. What guards and variables have to do with it, the
 * analysis of that code knows, which says all that this law says: it is told only of states that
 * are reached for sure.
 */
public final class TransitionsApart implements Check.OnAutomaton {
    /** Under these, all that transitions do not say is decided; under others, much is left open. */
    private static final Set<String> DECIDED = Set.of("ignore", "error");

    @Override
    public void check(AutomatonSymbol automaton, Context context, Findings findings) {
        boolean decides = automaton.stereotype("completion").filter(DECIDED::contains).isPresent();
        boolean runs =
                automaton
                        .component()
                        .map(each -> !each.isEventDriven() && !each.isDecomposed())
                        .orElse(true);
        if (!decides
                || !runs
                || !Automata.isExamined(automaton)
                || !StateReached.isWhole(automaton)) {
            return;
        }
        List<List<TransitionSymbol>> outgoing = StateReached.outgoing(automaton);
        BitSet reached = reachedForSure(automaton, outgoing);
        reached.stream().forEach(state -> compare(outgoing.get(state), findings));
    }

    private static void compare(List<TransitionSymbol> outgoing, Findings findings) {
        for (int i = 0; i < outgoing.size(); i++) {
            for (TransitionSymbol second : outgoing.subList(i + 1, outgoing.size())) {
                if (meet(outgoing.get(i), second)) {
                    report(outgoing.get(i), second, findings);
                }
            }
        }
    }

    private static boolean meet(TransitionSymbol first, TransitionSymbol second) {
        Optional<SureTrigger> trigger = SureTrigger.of(first);
        return trigger.isPresent()
                && SureTrigger.of(second).filter(trigger.get()::meets).isPresent();
    }

    /** By transitions that some letter enables, and that cannot go wrong: they write constants. */
    private static BitSet reachedForSure(
            AutomatonSymbol automaton, List<List<TransitionSymbol>> outgoing) {
        boolean begins =
                automaton.memory().stream()
                        .flatMap(each -> each.initial().stream())
                        .allMatch(each -> SureTrigger.constant(each.expression()).isPresent());
        List<StateSymbol> starts =
                automaton.initials().stream()
                        .filter(initial -> begins && areConstant(initial.items()))
                        .map(initial -> initial.state().orElseThrow())
                        .toList();
        return StateReached.reached(
                starts,
                outgoing,
                each -> areConstant(each.output()) && SureTrigger.of(each).isPresent());
    }

    private static boolean areConstant(List<ItemSymbol> items) {
        return items.stream()
                .map(ItemSymbol::value)
                .map(ItemValue::expressions)
                .flatMap(List::stream)
                .allMatch(each -> SureTrigger.constant(each.expression()).isPresent());
    }

    private static void report(TransitionSymbol first, TransitionSymbol second, Findings findings) {
        findings.report(
                        first.node(),
                        "two transitions out of %s are enabled together: 'arcomat analyze' shows a"
                                + " run",
                        first.source().orElseThrow().name())
                .related(second.node(), "this one is enabled as well");
    }
}
