package arcomat.check.structure.component;

import arcomat.check.facts.MeantParts;
import arcomat.check.law.Check;
import arcomat.source.Fix;
import arcomat.source.Span;
import arcomat.symbols.bodies.ComponentSymbol;
import arcomat.tree.Element;

/** ARC0142: a part is declared with the word {@code component}; without it, it is a variable. */
public final class PartNeedsKeyword implements Check.OnComponent {

    @Override
    public void check(ComponentSymbol component, Context context, Findings findings) {
        for (Element.Variables meant : MeantParts.in(component)) {
            Findings finding =
                    findings.report(
                            meant.type(),
                            "'%s' is a component: an instance needs the keyword 'component'",
                            meant.type().name());
            if (meant.variables().stream().allMatch(each -> each.initial().isEmpty())) {
                Span start = meant.span();
                finding.fix(
                        Fix.replace(
                                "Write 'component'",
                                new Span(start.file(), start.start(), meant.type().span().start()),
                                "component "));
            }
        }
    }
}
