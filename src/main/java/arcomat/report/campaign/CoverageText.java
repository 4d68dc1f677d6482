package arcomat.report.campaign;

import arcomat.campaign.coverage.Coverage;
import arcomat.report.text.Printable;

import java.util.ArrayList;
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
        if (coverage.runs() > 0) {
            list(
                    "no run: ",
                    MissingItem.of(coverage).stream().map(CoverageText::shown).toList(),
                    text);
        }
        if (coverage.runs() > 0 && coverage.isShared()) {
            text.append(amountByPart()).append('\n');
            list("not in ", missingByPart(), text);
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

    private String amountByPart() {
        List<Coverage.OfPart> parts = coverage.parts();
        return "by each part: %,d of %,d transitions, %,d of %,d states"
                .formatted(
                        parts.stream().mapToInt(Coverage.OfPart::taken).sum(),
                        parts.stream().mapToInt(each -> each.transitions().size()).sum(),
                        parts.stream().mapToInt(Coverage.OfPart::visited).sum(),
                        parts.stream().mapToInt(each -> each.states().size()).sum());
    }

    private static void list(String head, List<String> missing, StringBuilder text) {
        missing.stream().limit(MOST).forEach(each -> text.append(head).append(each).append('\n'));
        if (missing.size() > MOST) {
            int rest = missing.size() - MOST;
            text.append("%s%,d more, see --report\n".formatted(head, rest));
        }
    }

    /** What another part of the same component has covered. */
    private List<String> missingByPart() {
        List<String> missing = new ArrayList<>();
        for (Coverage.OfAutomaton all : coverage.automata()) {
            for (Coverage.OfPart part : all.parts()) {
                String name = Printable.escape(part.part().name());
                MissingItem.of(part, all).forEach(each -> missing.add(name + ": " + shown(each)));
            }
        }
        return missing;
    }

    private static String shown(MissingItem missing) {
        return Printable.escape(missing.place() + ": " + missing.text());
    }
}
