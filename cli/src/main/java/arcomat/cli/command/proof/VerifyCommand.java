package arcomat.cli.command.proof;

import arcomat.analysis.refinement.Answered;
import arcomat.analysis.refinement.Verdict;
import arcomat.cli.command.LimitedCommand;
import arcomat.cli.option.CheckRendering;
import arcomat.cli.option.CommandResults;
import arcomat.cli.option.DiskOption;
import arcomat.cli.option.DoubtedOption;
import arcomat.cli.option.PageReportOptions;
import arcomat.cli.option.ReportFormat;
import arcomat.cli.option.StrictOption;
import arcomat.cli.terminal.ExitStatus;
import arcomat.pipeline.Session;
import arcomat.pipeline.WrongUse;
import arcomat.pipeline.analysis.Disk;
import arcomat.pipeline.analysis.VerifyPromises;
import arcomat.pipeline.check.Aside;
import arcomat.pipeline.check.CheckedAnswer;
import arcomat.report.finding.JunitXml;
import arcomat.report.finding.Reported;
import arcomat.report.text.Style;
import arcomat.report.verdict.ObligationsText;
import arcomat.report.verdict.VerdictCases;
import arcomat.report.verdict.VerdictFindings;
import arcomat.report.verdict.VerdictJson;
import arcomat.report.verdict.VerdictPage;

import picocli.CommandLine;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Option;
import picocli.CommandLine.Parameters;

import java.util.List;
import java.util.Optional;

/** {@code arcomat verify}: whether models keep all promises that they say they keep. */
@CommandLine.Command(
        name = "verify",
        description = "Proves all that models say they keep: refines, requirements, invariants.",
        footer = {
            "  arcomat verify models/coffee",
            "  arcomat verify --timeout 60 --format json models > verdicts.json",
            "  arcomat verify --disk explored models    goes on where it was ended",
            "  arcomat verify --report junit=build/verify.xml --report sarif=build/verify.sarif"
                    + " models",
            "",
            "Exit status: 0 all hold; 1 one fails; 3 one is unknown; 2 wrong use or models with"
                    + " errors."
        })
public final class VerifyCommand extends LimitedCommand {
    @Option(
            names = "--certificate",
            paramLabel = "FILE",
            description = "Of all that holds, write down why.")
    private String certificate;

    @Mixin private DoubtedOption doubted = new DoubtedOption();

    @Mixin private DiskOption onDisk = new DiskOption();

    @Mixin private StrictOption strict = new StrictOption();

    @Mixin private PageReportOptions reports = new PageReportOptions();

    @Parameters(paramLabel = "PATH", arity = "1..*", description = "Model files and model roots.")
    private List<String> paths;

    @Override
    protected int run(Session session) throws WrongUse {
        Optional<String> proofs = doubted.file(certificate);
        Optional<Disk> disk = onDisk.disk();
        if (disk.isPresent() && (certificate != null || proofs.isPresent())) {
            throw new WrongUse(
                    "--disk is for a search without certificates; leave one of them out");
        }
        reports.prepare(session);
        CheckedAnswer<List<Answered>> reply =
                session.run(
                        new VerifyPromises(
                                paths, Optional.ofNullable(certificate), proofs, disk, limits()));
        tellAside(reply.check());
        if (reply.value().isEmpty()) {
            CheckRendering findings =
                    CheckRendering.refused("verify", reply.check(), machineFormats());
            reports.write(findings.results(), session, console());
            return ExitStatus.WRONG_USE;
        }
        List<Answered> answers = reply.value().get();
        reports.writePage(
                () -> VerdictPage.of("verify", String.join(", ", paths), answers, limitsInWords()),
                session);
        Aside aside = reply.check().aside();
        reports.write(
                new CommandResults(
                        "verify",
                        (format, style) -> text(answers, aside, format, style),
                        () -> reported(answers, aside)),
                session,
                console());
        return aside.isEmpty() ? status(strict.of(answers)) : ExitStatus.WRONG_USE;
    }

    private String text(List<Answered> answers, Aside aside, ReportFormat format, Style style) {
        List<Reported> findings = reported(answers, aside);
        return switch (format) {
            case text -> ObligationsText.all(answers, style);
            case json -> VerdictJson.render(answers);
            case sarif -> machineFormats().sarif(findings, false);
            case github -> machineFormats().github(findings, summary(answers, style));
            case junit ->
                    JunitXml.render(
                            "arcomat verify",
                            CheckRendering.withCasesAside(VerdictCases.of(answers), aside));
        };
    }

    private static List<Reported> reported(List<Answered> answers, Aside aside) {
        return CheckRendering.withAside(VerdictFindings.of(answers), aside);
    }

    private static String summary(List<Answered> answers, Style style) {
        List<Verdict> verdicts = answers.stream().map(Answered::verdict).toList();
        return ObligationsText.summary(verdicts, style) + "\n";
    }
}
