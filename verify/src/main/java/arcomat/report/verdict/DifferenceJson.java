package arcomat.report.verdict;

import arcomat.analysis.refinement.Difference;
import arcomat.report.text.Json;
import arcomat.report.text.Printable;

import java.util.List;

/** How two components compare, for programs. */
public record DifferenceJson(
        String left,
        String right,
        String relation,
        List<VerdictJson> forward,
        List<VerdictJson> backward) {
    public static String render(String left, String right, Difference difference) {
        return Json.text(
                new DifferenceJson(
                        left,
                        right,
                        Printable.word(difference.relation()),
                        difference.forward().stream().map(VerdictJson::of).toList(),
                        difference.backward().stream().map(VerdictJson::of).toList()));
    }
}
