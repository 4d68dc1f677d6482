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
            list(missing(), "no run: ", "no run: %,d more, see --report\n", text);
            if (coverage.isShared()) {
                text.append(amountByPart()).append('\n');
                list(missingByPart(), "not in ", "not in %,d more parts: see --report\n", text);
            }
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

    private static void list(List<String> missing, String head, String rest, StringBuilder text) {
        missing.stream().limit(MOST).forEach(each -> text.append(head).append(each).append('\n'));
        if (missing.size() > MOST) {
            text.append(rest.formatted(missing.size() - MOST));
        }
    }

    private List<String> missing() {
        return MissingItem.of(coverage).stream().map(CoverageText::shown).toList();
    }

    /** What another part of the same component has covered: a line for each part. */
    private List<String> missingByPart() {
        List<String> missing = new ArrayList<>();
        for (Coverage.OfAutomaton all : coverage.automata()) {
            for (Coverage.OfPart part : all.parts()) {
                List<MissingItem> own = MissingItem.of(part, all);
                if (!own.isEmpty()) {
                    String name = Printable.escape(part.part().name());
                    String rest = own.size() > 1 ? " and %,d more".formatted(own.size() - 1) : "";
                    missing.add(name + ": " + shown(own.get(0)) + rest);
                }
            }
        }
        return missing;
    }

    private static String shown(MissingItem missing) {
        return Printable.escape(missing.place() + ": " + missing.text());
    }
}
