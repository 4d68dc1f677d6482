package arcomat.agent.tool;

import arcomat.pipeline.check.Aside;
import arcomat.pipeline.check.CheckResult;
import arcomat.pipeline.check.CheckedAnswer;
import arcomat.report.finding.CheckReport;
import arcomat.report.finding.FindingsJson;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.function.Function;

/**
 * What a tool has to say.
 *
 * @param text the record that the command prints for programs, or a page
 * @param remarks sentences beside it, which the command tells on its standard error
 */
public record ToolAnswer(String text, List<String> remarks) {
    private static final String REFUSED =
            "The models have errors, so the question was not asked; these are their findings.";

    public ToolAnswer {
        remarks = List.copyOf(remarks);
    }

    public ToolAnswer(String text) {
        this(text, List.of());
    }

    /** The answer of models; their findings where they have errors. */
    static <T> ToolAnswer of(CheckedAnswer<T> reply, Function<T, String> record) {
        return reply.value().isPresent()
                ? new ToolAnswer(record.apply(reply.value().get()), remarks(reply.check().aside()))
                : refused(reply.check());
    }

    private static ToolAnswer refused(CheckResult check) {
        List<String> remarks = new ArrayList<>(List.of(REFUSED));
        remarks.addAll(remarks(check.aside()));
        return new ToolAnswer(findings(check), remarks);
    }

    static String findings(CheckResult check) {
        return FindingsJson.render(
                new CheckReport(
                        check.paths(), check.findings(), check.suppressed(), Optional.empty()));
    }

    /** Files that a tool went on without. */
    static List<String> remarks(Aside aside) {
        return aside.isEmpty()
                ? List.of()
                : List.of(
                        "Left out, with errors or in need of a file that has: "
                                + String.join(", ", aside.files())
                                + ". The tool 'check' has the findings.");
    }
}
