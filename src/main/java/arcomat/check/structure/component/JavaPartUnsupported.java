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
    private static final int LONGEST = 40;

    @Override
    public void check(ComponentSymbol component, Context context, Findings findings) {
        for (Element.JavaPart part : component.node().elements(Element.JavaPart.class)) {
            part.first()
                    .ifPresentOrElse(
                            first -> report(part, first.span(), findings),
                            () ->
                                    findings.report(
                                            word(part),
                                            "'%s' is taken for Java with what stands beside it, and"
                                                    + " is not run",
                                            part.keyword()));
        }
    }

    /** At the place where it shows: who meant statements has made a mistake there. */
    private static void report(Element.JavaPart part, Span first, Findings findings) {
        findings.report(
                        first,
                        "'%s' cannot stand here in statements, so all of '%s' is taken for Java,"
                            + " which is not run; correct it, describe the behaviour with an"
                            + " automaton or a table, or mark the component <<platform>> and write"
                            + " its Java class by hand",
                        shortened(first.text()),
                        part.keyword())
                .related(word(part), "taken for Java");
    }

    private static Span word(Element.JavaPart part) {
        Span span = part.span();
        return new Span(span.file(), span.start(), span.start() + part.keyword().length());
    }

    private static String shortened(String text) {
        String line = text.strip().replaceAll("\\s+", " ");
        return line.length() <= LONGEST ? line : line.substring(0, LONGEST - 2) + "..";
    }
}
