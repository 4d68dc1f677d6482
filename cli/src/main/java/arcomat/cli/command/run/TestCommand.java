package arcomat.cli.command.run;

import arcomat.cli.command.Command;
import arcomat.cli.option.CheckRendering;
import arcomat.cli.option.CommandResults;
import arcomat.cli.option.LibraryOption;
import arcomat.cli.option.PageReportOptions;
import arcomat.cli.option.ReportFormat;
import arcomat.cli.terminal.ExitStatus;
import arcomat.pipeline.Session;
import arcomat.pipeline.WrongUse;
import arcomat.pipeline.check.Aside;
import arcomat.pipeline.check.CheckResult;
import arcomat.pipeline.check.CheckedAnswer;
import arcomat.pipeline.simulate.RunStreamTests;
import arcomat.report.finding.JunitXml;
import arcomat.report.finding.Reported;
import arcomat.report.run.StreamTestCases;
import arcomat.report.run.StreamTestFindings;
import arcomat.report.run.StreamTestJson;
import arcomat.report.run.StreamTestPage;
import arcomat.report.run.StreamTestText;
import arcomat.report.text.Style;
import arcomat.simulate.test.StreamTestResult;
import arcomat.simulate.test.StreamTestResult.Verdict;

import picocli.CommandLine;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Parameters;

import java.util.List;
import java.util.Set;
import java.util.stream.Collectors;

/** {@code arcomat test}: runs stream tests against their models. */
@CommandLine.Command(
        name = "test",
        description = "Runs the stream tests (.mt) of models.",
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

    @Mixin private LibraryOption library = new LibraryOption();

    @Parameters(paramLabel = "PATH", arity = "1..*", description = "Suites (.mt) and model roots.")
    private List<String> paths;

    @Override
    protected List<String> libraries() {
        return library.folders();
    }

    @Override
    protected int run(Session session) throws WrongUse {
        reports.prepare(session);
        CheckedAnswer<List<StreamTestResult>> reply = session.run(new RunStreamTests(paths));
        CheckResult check = reply.check();
        tellAside(check);
        if (reply.value().isEmpty()) {
            reports.write(
                    CheckRendering.refused("test", check, machineFormats()).results(),
                    session,
                    console());
            return check.hasUnreadableInput() ? ExitStatus.WRONG_USE : ExitStatus.FINDINGS;
        }
        List<StreamTestResult> tests = reply.value().get();
        Aside aside = check.aside();
        reports.writePage(() -> StreamTestPage.of(String.join(", ", paths), tests), session);
        reports.write(
                new CommandResults(
                        "test",
                        (format, style) -> text(tests, aside, format, style),
                        () -> reported(tests, aside)),
                session,
                console());
        return aside.isEmpty() ? status(tests) : ExitStatus.FINDINGS;
    }

    private static int status(List<StreamTestResult> tests) {
        Set<Verdict> verdicts =
                tests.stream().map(StreamTestResult::verdict).collect(Collectors.toSet());
        if (verdicts.contains(Verdict.FAILED)) {
            return ExitStatus.FINDINGS;
        }
        return verdicts.contains(Verdict.UNKNOWN) ? ExitStatus.UNKNOWN : ExitStatus.FINE;
    }

    private static List<Reported> reported(List<StreamTestResult> tests, Aside aside) {
        return CheckRendering.withAside(StreamTestFindings.of(tests), aside);
    }

    private String text(
            List<StreamTestResult> tests, Aside aside, ReportFormat format, Style style) {
        List<Reported> findings = reported(tests, aside);
        String summary = StreamTestText.summary(tests, style) + "\n";
        return switch (format) {
            case text -> StreamTestText.render(tests, style) + summary;
            case json -> StreamTestJson.render(tests);
            case sarif -> machineFormats().sarif(findings, false);
            case github -> machineFormats().github(findings, summary);
            case junit ->
                    JunitXml.render(
                            "arcomat test",
                            CheckRendering.withCasesAside(StreamTestCases.of(tests), aside));
        };
    }
}
