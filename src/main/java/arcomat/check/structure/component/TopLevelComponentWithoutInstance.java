package arcomat.check.structure.component;

import arcomat.check.law.Check;
import arcomat.source.Fix;
import arcomat.source.Span;
import arcomat.tree.Component;
import arcomat.tree.Unit;

/**
 * ARC0101: the component of a file has no instance name; it is instantiated by those that use it.
 * (Hab16 B2)
 */
public final class TopLevelComponentWithoutInstance implements Check.OnUnit {

    @Override
    public void check(Unit unit, Context context, Findings findings) {
        if (unit.definition() instanceof Component component && component.instance().isPresent()) {
            Component.NamedInstance instance = component.instance().get();
            findings.report(
                            instance,
                            "top-level component '%s' cannot have the instance name '%s'; delete"
                                    + " it",
                            component.name(),
                            instance.name())
                    .fix(Fix.replace("Delete the instance name", withSpace(instance.span()), ""));
        }
    }

    private static Span withSpace(Span span) {
        int start = span.start();
        while (start > 0 && Character.isWhitespace(span.file().text().charAt(start - 1))) {
            start--;
        }
        return new Span(span.file(), start, span.end());
    }
}
