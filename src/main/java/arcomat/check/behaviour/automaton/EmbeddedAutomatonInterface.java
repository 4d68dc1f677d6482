package arcomat.check.behaviour.automaton;

import arcomat.check.law.Check;
import arcomat.symbols.bodies.AutomatonSymbol;
import arcomat.tree.AutomatonElement.Declaration;
import arcomat.tree.AutomatonElement.Kind;

import java.util.Locale;

/** ARC0324: an automaton inside a component declares neither inputs nor outputs. */
public final class EmbeddedAutomatonInterface implements Check.OnAutomaton {

    @Override
    public void check(AutomatonSymbol automaton, Context context, Findings findings) {
        if (context.component().isEmpty()) {
            return;
        }
        for (Declaration declaration : automaton.node().elements(Declaration.class)) {
            if (declaration.kind() != Kind.VARIABLE) {
                findings.report(
                        declaration,
                        "an automaton inside a component uses the component's ports; move this %s"
                                + " to the ports of '%s'",
                        declaration.kind().name().toLowerCase(Locale.ROOT),
                        context.component().get().name());
            }
        }
    }
}
