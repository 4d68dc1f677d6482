package arcomat.cli.command.proof;

import arcomat.analysis.evolution.Gate;
import arcomat.cli.command.LimitedCommand;
import arcomat.cli.option.CheckRendering;
import arcomat.cli.option.ReportFormat;
import arcomat.cli.option.ReportOptions;
import arcomat.cli.terminal.ExitStatus;
import arcomat.cli.terminal.MachineFormats;
import arcomat.pipeline.Session;
import arcomat.pipeline.WrongUse;
import arcomat.pipeline.check.Aside;
import arcomat.pipeline.check.CheckResult;
import arcomat.pipeline.gate.PassGate;
import arcomat.report.finding.JunitXml;
import arcomat.report.finding.Reported;
import arcomat.report.finding.Reported.Standing;
import arcomat.report.text.Style;
import arcomat.report.verdict.GateCases;
import arcomat.report.verdict.GateJson;
import arcomat.report.verdict.GateText;
import arcomat.source.Diagnostic;
import arcomat.source.Suppressed;

import picocli.CommandLine;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Option;
import picocli.CommandLine.Parameters;

import java.util.ArrayList;
import java.util.List;

/** {@code arcomat gate}: whether components still keep what they promised. */
@CommandLine.Command(
        name = "gate",
        description = {
            "Compares every component with what it was on main: does it keep its promises?",
            "One that does not is let through only if the model says why:",
            "<<breaks = \"reason\">> on it, <<replaces = \"p.Old: reason\">> for one that is gone."
        },
        footer = {
            "  git worktree add ../main main",
            "  arcomat gate --base ../main/models models",
            "  arcomat gate --base ../main/models --report junit=build/gate.xml models",
            "",
            "Exit status: 0 all keep their promises; 1 one does not; 3 one is unknown; 2 wrong use"
                    + " or models with errors."
        })
public final class GateCommand extends LimitedCommand {
    @Mixin private ReportOptions reports = new ReportOptions();

    @Option(
            names = "--base",
            paramLabel = "DIR",
            required = true,
            description = "The same model root as it was: a checkout of main. May be repeated.")
    private List<String> base;

    @Parameters(paramLabel = "PATH", arity = "1..*", description = "Model files and model roots.")
    private List<String> paths;

    /** It holds for each comparison. */
    @Override
    protected boolean isTimeOfAll() {
        return false;
    }

    @Override
    protected int run(Session session) throws WrongUse {
        PassGate.Result result = session.run(new PassGate(base, paths, limits()));
        tellAside(result.aside());
        if (result.gate().isEmpty()) {
            reports.write((format, style) -> refusal(result, format, style), session, console());
            return ExitStatus.WRONG_USE;
        }
        reports.write((format, style) -> text(result, format, style), session, console());
        return result.aside().isEmpty()
                ? status(result.gate().get().answer())
                : ExitStatus.WRONG_USE;
    }

    private String text(PassGate.Result result, ReportFormat format, Style style) {
        Gate gate = result.gate().orElseThrow();
        List<Diagnostic> findings = result.findings();
        Aside aside = result.aside();
        return switch (format) {
            case text -> GateText.render(gate, findings, style);
            case json -> GateJson.render(gate, findings, aside.findings(), aside.files());
            case sarif -> MachineFormats.of(console()).sarif(reported(result), false);
            case github ->
                    MachineFormats.of(console())
                            .github(reported(result), GateText.summary(gate, style));
            case junit ->
                    JunitXml.render(
                            "arcomat gate",
                            CheckRendering.withCasesAside(GateCases.of(gate), aside));
        };
    }

    private static List<Reported> reported(PassGate.Result result) {
        List<Reported> all = new ArrayList<>();
        for (Diagnostic finding : result.findings()) {
            all.add(new Reported(finding, Standing.NEW, "", List.of()));
        }
        for (Suppressed each : result.meant()) {
            all.add(new Reported(each.finding(), Standing.SUPPRESSED, each.reason(), List.of()));
        }
        return CheckRendering.withAside(all, result.aside());
    }

    /** What keeps the sides from being compared: for people, which side it is. */
    private String refusal(PassGate.Result result, ReportFormat format, Style style) {
        if (format == ReportFormat.text) {
            return refusal("the base", base, result.base(), style)
                    + refusal("the new models", paths, result.check(), style);
        }
        CheckResult both = result.base().and(result.check());
        return CheckRendering.refused("gate", both, console()).text(format, style);
    }

    private String refusal(String side, List<String> where, CheckResult check, Style style) {
        return check.hasErrors()
                ? "%s (%s):\n".formatted(side, String.join(", ", where))
                        + CheckRendering.refused("gate", check, console())
                                .text(ReportFormat.text, style)
                : "";
    }
}
