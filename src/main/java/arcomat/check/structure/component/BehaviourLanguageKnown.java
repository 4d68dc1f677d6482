package arcomat.check.structure.component;

import arcomat.check.law.Check;
import arcomat.source.Fix;
import arcomat.source.Nearest;
import arcomat.symbols.bodies.ComponentSymbol;
import arcomat.tree.Behaviour;
import arcomat.tree.Name;

import java.util.List;
import java.util.Optional;

/** ARC0133: somebody knows the language that a behaviour is written in. */
public final class BehaviourLanguageKnown implements Check.OnComponent {
    /** The tool's own words, where somebody meant one of them. */
    private static final List<String> OWN = List.of("automaton", "implementation", "table");

    @Override
    public void check(ComponentSymbol component, Context context, Findings findings) {
        for (Behaviour.Foreign behaviour : component.node().elements(Behaviour.Foreign.class)) {
            if (behaviour.automata().isEmpty() && !component.readings().containsKey(behaviour)) {
                report(behaviour.keyword(), findings);
            }
        }
    }

    private static void report(Name keyword, Findings findings) {
        Optional<String> meant = Nearest.to(keyword.text(), OWN);
        if (meant.isEmpty()) {
            findings.report(
                    keyword,
                    "no behaviour language is called '%s'; name the guest that brings it, with"
                            + " --with, or write an automaton or a table",
                    keyword.text());
            return;
        }
        findings.report(
                        keyword,
                        "no behaviour language is called '%s'; did you mean '%s'?",
                        keyword.text(),
                        meant.get())
                .fix(
                        Fix.replace(
                                "Replace '%s' by '%s'".formatted(keyword.text(), meant.get()),
                                keyword.span(),
                                meant.get()));
    }
}
