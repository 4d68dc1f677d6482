package arcomat.check.naming;

import arcomat.check.law.Check;
import arcomat.source.Fix;
import arcomat.source.Signs;
import arcomat.source.Span;
import arcomat.tree.Unit;

/**
 * ARC0219: no comment and no literal changes the order in which a line is shown. Elsewhere such a
 * character is a syntax error.
 */
public final class DirectionUnchanged implements Check.OnUnit {

    @Override
    public void check(Unit unit, Context context, Findings findings) {
        String text = unit.file().text();
        for (int i = 0; i < text.length(); i++) {
            if (Signs.changesDirection(text.charAt(i))) {
                report(unit, unit.file().span(i, i + 1), findings);
            }
        }
    }

    private static void report(Unit unit, Span place, Findings findings) {
        boolean inComment = unit.comments().stream().anyMatch(each -> each.span().isAround(place));
        String quoted = Signs.quoted(place.text().charAt(0));
        String message = "the character %s changes the order in which this line is shown; %s";
        if (inComment) {
            findings.report(place, message, quoted, "remove it")
                    .fix(Fix.replace("Remove the character", place, ""));
            return;
        }
        String escape = Signs.withoutDirections(place.text());
        findings.report(place, message, quoted, "write " + escape)
                .fix(Fix.replace("Write " + escape, place, escape));
    }
}
