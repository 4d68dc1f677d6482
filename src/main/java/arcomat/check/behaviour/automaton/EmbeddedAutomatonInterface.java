package arcomat.check.behaviour.automaton;

import arcomat.check.law.Check;
import arcomat.check.law.Context;
import arcomat.check.law.Findings;
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
                findings.report(declaration, message(declaration, context));
            }
        }
    }

    private static String message(Declaration declaration, Context context) {
        return "an automaton inside a component uses the component's ports; move this %s to the ports of '%s'"
                .formatted(
                        declaration.kind().name().toLowerCase(Locale.ROOT),
                        context.component().orElseThrow().name());
    }
}
