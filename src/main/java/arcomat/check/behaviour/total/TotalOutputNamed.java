package arcomat.check.behaviour.total;

import arcomat.check.behaviour.item.Items;
import arcomat.check.facts.Wording;
import arcomat.check.law.Check;
import arcomat.symbols.bodies.ActionSymbol;
import arcomat.symbols.bodies.AutomatonSymbol;
import arcomat.symbols.bodies.AutomatonSymbol.InitialSymbol;
import arcomat.symbols.bodies.ItemSymbol;
import arcomat.symbols.bodies.TransitionSymbol;
import arcomat.symbols.expressions.PortSymbol;
import arcomat.tree.Block;
import arcomat.tree.Node;

import java.util.List;
import java.util.Optional;
import java.util.Set;

/** ARC0327: every block sends a message on each total output. */
public final class TotalOutputNamed implements Check.OnAutomaton {

    @Override
    public void check(AutomatonSymbol automaton, Context context, Findings findings) {
        List<PortSymbol> total = TotalOutputs.of(automaton);
        if (total.isEmpty()) {
            return;
        }
        List<PortSymbol> delayed =
                Items.isRequirement(automaton)
                        ? List.of()
                        : total.stream().filter(port -> port.delay() == 1).toList();
        for (InitialSymbol initial : automaton.initials()) {
            check(
                    initial.items(),
                    initial.actions(),
                    initial.node().output(),
                    initial.node(),
                    delayed,
                    findings);
        }
        for (TransitionSymbol transition : automaton.transitions()) {
            check(
                    transition.output(),
                    transition.actions(),
                    transition.node().output(),
                    transition.node(),
                    total,
                    findings);
        }
    }

    /** An item that does not resolve may be meant for any port; it has a finding already. */
    private static void check(
            List<ItemSymbol> items,
            Optional<ActionSymbol> actions,
            Optional<Block> block,
            Node clause,
            List<PortSymbol> total,
            Findings findings) {
        if (items.stream().anyMatch(item -> item.target().found().isEmpty())) {
            return;
        }
        Set<PortSymbol> sent =
                actions.map(each -> each.match(new SurelySent(Set.of())))
                        .orElseGet(() -> SurelySent.atOnce(items));
        List<PortSymbol> missing = total.stream().filter(port -> !sent.contains(port)).toList();
        if (!missing.isEmpty()) {
            Node place =
                    actions.<Node>map(ActionSymbol::node)
                            .or(() -> block.map(each -> each))
                            .orElse(clause);
            report(place, missing, findings);
        }
    }

    private static void report(Node place, List<PortSymbol> missing, Findings findings) {
        List<String> names = missing.stream().map(PortSymbol::name).toList();
        findings.report(
                place,
                "no message is sent here on %s, which %s one in every slice (<<total>>); say which"
                        + " one",
                Wording.quoted(names),
                names.size() == 1 ? "carries" : "carry");
        for (PortSymbol port : missing) {
            findings.related(port.nameSpan(), "declared <<total>>");
        }
    }
}
