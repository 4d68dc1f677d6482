package arcomat.check.structure.component;

import arcomat.check.law.Check;
import arcomat.source.Span;
import arcomat.symbols.bodies.ComponentSymbol;
import arcomat.tree.Element;

/**
 * ARC0127: behaviour is not written in Java. The {@code compute} and {@code init} parts of 2017
 * models are kept and printed, but nothing can be said about them and no target runs them.
 */
public final class JavaPartUnsupported implements Check.OnComponent {

    @Override
    public void check(ComponentSymbol component, Context context, Findings findings) {
        for (Element.JavaPart part : component.node().elements(Element.JavaPart.class)) {
            Span span = part.span();
            findings.report(
                    new Span(span.file(), span.start(), span.start() + part.keyword().length()),
                    "Java code in '%s' is not run; describe the behaviour with an automaton or a"
                        + " table, or mark the component <<platform>> and write its Java class by"
                        + " hand",
                    part.keyword());
        }
    }
}
