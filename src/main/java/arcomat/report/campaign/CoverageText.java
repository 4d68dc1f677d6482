package arcomat.report.campaign;

import arcomat.campaign.coverage.Coverage;
import arcomat.report.text.Printable;

import java.util.List;

/** What runs have covered, for people: how much, and some of what none of them came to. */
public final class CoverageText {
    /** A list that is longer is read by nobody; the page has it. */
    private static final int MOST = 3;

    private final Coverage coverage;

    public CoverageText(Coverage coverage) {
        this.coverage = coverage;
    }

    /** Nothing where no run was made. */
    public String render() {
        StringBuilder text = new StringBuilder();
        if (coverage.runs() > 0) {
            text.append(amount()).append('\n');
        }
        List<String> missing = coverage.runs() > 0 ? missing() : List.of();
        missing.stream()
                .limit(MOST)
                .forEach(each -> text.append("no run: ").append(each).append('\n'));
        if (missing.size() > MOST) {
            text.append("no run: %,d more, see --report\n".formatted(missing.size() - MOST));
        }
        coverage.jars().forEach(each -> text.append(unknown(each)).append('\n'));
        return text.toString();
    }

    private static String unknown(String jar) {
        return "covered: nobody knows of '%s', which was given without models"
                .formatted(Printable.escape(jar));
    }

    private String amount() {
        return "covered: %,d of %,d transitions, %,d of %,d states"
                .formatted(
                        coverage.taken(),
                        coverage.transitions(),
                        coverage.visited(),
                        coverage.states());
    }

    private List<String> missing() {
        return MissingItem.of(coverage).stream()
                .map(each -> Printable.escape(each.place() + ": " + each.text()))
                .toList();
    }
}
