package arcomat.cli.command;

import arcomat.cli.option.PageReportOptions;
import arcomat.cli.option.ReportFormat;
import arcomat.cli.terminal.Console;
import arcomat.cli.terminal.ExitStatus;
import arcomat.cli.terminal.MachineFormats;
import arcomat.pipeline.Pipeline;
import arcomat.pipeline.check.CheckResult;
import arcomat.pipeline.simulate.TestResult;
import arcomat.pipeline.step.WrongUse;
import arcomat.report.finding.JunitXml;
import arcomat.report.finding.JunitXml.Case;
import arcomat.report.finding.Reported;
import arcomat.report.run.StreamTestCases;
import arcomat.report.run.StreamTestFindings;
import arcomat.report.run.StreamTestJson;
import arcomat.report.run.StreamTestPage;
import arcomat.report.run.StreamTestText;
import arcomat.report.text.Style;

import picocli.CommandLine;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Parameters;

import java.util.List;

/** {@code arcomat test}: runs stream tests against their models. */
@CommandLine.Command(
        name = "test",
        description = "Runs the stream tests (.mt) of models.",
        footerHeading = "%nExamples:%n",
        footer = {
            "  arcomat test models/coffee",
            "  arcomat test models/coffee/coffee/fig6/AvoidCrashTest.mt",
            "  arcomat test --report junit=build/tests.xml models/coffee",
            "  arcomat test --report build/tests models/coffee",
            "",
            "A test passes if what it expects is among the outputs that its model allows. It",
            "passes vacuously if the model allows it only because it promises nothing any more.",
            "",
            "Exit status: 0 all pass; 1 one fails, or models have errors; 3 one is unknown; 2 wrong"
                    + " use."
        })
public final class TestCommand extends Command {
    @Mixin private PageReportOptions reports = new PageReportOptions();

    @Parameters(paramLabel = "PATH", arity = "1..*", description = "Suites (.mt) and model roots.")
    private List<String> paths;

    public TestCommand(Console console) {
        super(console);
    }

    @Override
    int run(Pipeline pipeline) throws WrongUse {
        reports.prepare(pipeline);
        TestResult result = pipeline.test(paths);
        tellAside(result.check());
        CheckResult check = result.check();
        if (check.hasErrors()) {
            reports.write(CheckRendering.refused("test", check, console), pipeline, console);
            return check.hasUnreadableInput() ? ExitStatus.WRONG_USE : ExitStatus.FINDINGS;
        }
        reports.writePage(
                () -> StreamTestPage.of(String.join(", ", paths), result.tests()), pipeline);
        reports.write((format, style) -> text(result, format, style), pipeline, console);
        return check.aside().isEmpty() ? status(result) : ExitStatus.FINDINGS;
    }

    private static int status(TestResult result) {
        if (result.hasFailures()) {
            return ExitStatus.FINDINGS;
        }
        return result.hasUnknown() ? ExitStatus.UNKNOWN : ExitStatus.FINE;
    }

    private String text(TestResult result, ReportFormat format, Style style) {
        return switch (format) {
            case text -> StreamTestText.render(result.tests(), style) + summary(result, style);
            case json -> StreamTestJson.render(result.tests());
            case sarif -> MachineFormats.of(console).sarif(findings(result), false);
            case github ->
                    MachineFormats.of(console).github(findings(result), summary(result, style));
            case junit -> JunitXml.render("arcomat test", cases(result));
        };
    }

    private static List<Reported> findings(TestResult result) {
        return CheckRendering.withAside(
                StreamTestFindings.of(result.tests()), result.check().aside());
    }

    private static List<Case> cases(TestResult result) {
        return CheckRendering.withCasesAside(
                StreamTestCases.of(result.tests()), result.check().aside());
    }

    private static String summary(TestResult result, Style style) {
        return StreamTestText.summary(result.tests(), style) + "\n";
    }
}
