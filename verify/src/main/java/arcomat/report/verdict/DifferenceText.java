package arcomat.report.verdict;

import arcomat.analysis.refinement.Difference;
import arcomat.analysis.refinement.Verdict;
import arcomat.report.text.Printable;
import arcomat.report.text.Style;

import java.util.List;

/** How two components compare, with a story for each step that only one of them makes. */
public final class DifferenceText {
    private DifferenceText() {}

    public static String render(String left, String right, Difference difference, Style style) {
        StringBuilder out = new StringBuilder();
        out.append(style.strong(Printable.escape(headline(left, right, difference)))).append('\n');
        append(left, right, difference.forward(), style, out);
        append(right, left, difference.backward(), style, out);
        return out.toString();
    }

    private static String headline(String left, String right, Difference difference) {
        return switch (difference.relation()) {
            case EQUIVALENT -> left + " and " + right + " are equivalent";
            case REFINES -> left + " refines " + right + ", and promises more";
            case IS_REFINED_BY -> right + " refines " + left + ", and promises more";
            case INCOMPARABLE -> left + " and " + right + " are incomparable";
            case UNKNOWN -> "how " + left + " and " + right + " compare is unknown";
        };
    }

    private static void append(
            String doer, String other, List<Verdict> verdicts, Style style, StringBuilder out) {
        for (int i = 0; i < verdicts.size(); i++) {
            if (verdicts.size() > 1) {
                out.append("\n%d of %d: ".formatted(i + 1, verdicts.size()));
            } else {
                out.append('\n');
            }
            out.append(VerdictText.render(doer, other, verdicts.get(i), style));
        }
    }
}
