package arcomat.check.behaviour.total;

import arcomat.check.law.Check;
import arcomat.symbols.bodies.AutomatonSymbol;
import arcomat.symbols.expressions.PortSymbol;
import arcomat.tree.Stereotype;

import java.util.List;

/** ARC0328: the completion {@code ignore} and a total output exclude each other. */
public final class IgnoreExcludesTotalOutput implements Check.OnAutomaton {

    @Override
    public void check(AutomatonSymbol automaton, Context context, Findings findings) {
        check(automaton.node().stereotypes(), TotalOutputs.of(automaton), findings);
    }

    private static void check(
            List<Stereotype> stereotypes, List<PortSymbol> total, Findings findings) {
        if (total.isEmpty()) {
            return;
        }
        Stereotype.find(stereotypes, "completion")
                .filter(each -> each.value().filter(v -> v.text().equals("ignore")).isPresent())
                .ifPresent(completion -> report(completion, total.get(0), findings));
    }

    private static void report(Stereotype completion, PortSymbol port, Findings findings) {
        findings.report(
                        completion,
                        "'ignore' sends nothing where no transition is enabled, but '%s' carries a"
                                + " message in every slice; use \"output\" or \"error\"",
                        port.name())
                .related(port.nameSpan(), "declared <<total>>");
    }
}
