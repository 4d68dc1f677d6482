package arcomat.cli.command;

import arcomat.analysis.refinement.Answered;
import arcomat.analysis.refinement.Verdict;
import arcomat.analysis.refinement.Verdict.Answer;
import arcomat.cli.option.PageReportOptions;
import arcomat.cli.option.Rendering;
import arcomat.cli.option.ReportFormat;
import arcomat.cli.terminal.Console;
import arcomat.cli.terminal.ExitStatus;
import arcomat.cli.terminal.MachineFormats;
import arcomat.pipeline.Pipeline;
import arcomat.pipeline.analysis.AnalysisResult;
import arcomat.pipeline.check.Aside;
import arcomat.pipeline.step.WrongUse;
import arcomat.report.finding.JunitXml;
import arcomat.report.finding.Reported;
import arcomat.report.text.Style;
import arcomat.report.verdict.ObligationsText;
import arcomat.report.verdict.VerdictCases;
import arcomat.report.verdict.VerdictFindings;
import arcomat.report.verdict.VerdictJson;
import arcomat.report.verdict.VerdictPage;
import arcomat.report.verdict.VerdictText;

import picocli.CommandLine;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Parameters;

import java.util.List;

/** {@code arcomat verify}: whether models keep all promises that they say they keep. */
@CommandLine.Command(
        name = "verify",
        description = "Proves all that models say they keep: refines, requirements, invariants.",
        footerHeading = "%nExamples:%n",
        footer = {
            "  arcomat verify models/coffee",
            "  arcomat verify --timeout 60 --format json models > verdicts.json",
            "  arcomat verify --report junit=build/verify.xml --report sarif=build/verify.sarif"
                    + " models",
            "",
            "Exit status: 0 all hold; 1 one fails; 3 one is unknown; 2 wrong use or models with"
                    + " errors."
        })
public final class VerifyCommand extends LimitedCommand {
    @Mixin private PageReportOptions reports = new PageReportOptions();

    @Parameters(paramLabel = "PATH", arity = "1..*", description = "Model files and model roots.")
    private List<String> paths;

    public VerifyCommand(Console console) {
        super(console);
    }

    @Override
    int run(Pipeline pipeline) throws WrongUse {
        reports.prepare(pipeline);
        AnalysisResult result = pipeline.verify(paths, limits());
        tellAside(result.check());
        if (result.check().hasErrors()) {
            Rendering findings = CheckRendering.refused("verify", result.check(), console);
            reports.write(findings, pipeline, console);
            return ExitStatus.WRONG_USE;
        }
        List<Answered> answers = result.answers();
        reports.writePage(
                () -> VerdictPage.of("verify", String.join(", ", paths), answers), pipeline);
        Aside aside = result.check().aside();
        reports.write((format, style) -> text(answers, aside, format, style), pipeline, console);
        return aside.isEmpty() ? status(result.answer()) : ExitStatus.WRONG_USE;
    }

    private String text(List<Answered> answers, Aside aside, ReportFormat format, Style style) {
        List<Reported> findings = CheckRendering.withAside(VerdictFindings.of(answers), aside);
        return switch (format) {
            case text -> text(answers, style) + summary(answers, style);
            case json -> VerdictJson.render(answers);
            case sarif -> MachineFormats.of(console).sarif(findings, false);
            case github -> MachineFormats.of(console).github(findings, summary(answers, style));
            case junit ->
                    JunitXml.render(
                            "arcomat verify",
                            CheckRendering.withCasesAside(VerdictCases.of(answers), aside));
        };
    }

    /** A line for each, then the failures at length. */
    private static String text(List<Answered> answers, Style style) {
        StringBuilder out = new StringBuilder();
        for (Answered each : answers) {
            out.append(ObligationsText.line(each, style));
        }
        for (Answered each : answers) {
            if (each.verdict().answer() == Answer.FAILS) {
                out.append('\n').append(VerdictText.render(each, style));
            }
        }
        return out.toString();
    }

    private static String summary(List<Answered> answers, Style style) {
        List<Verdict> verdicts = answers.stream().map(Answered::verdict).toList();
        return ObligationsText.summary(verdicts, style) + "\n";
    }
}
