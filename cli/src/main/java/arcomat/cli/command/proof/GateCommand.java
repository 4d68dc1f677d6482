package arcomat.cli.command.proof;

import arcomat.analysis.evolution.Gate;
import arcomat.analysis.refinement.Verdict.Answer;
import arcomat.cli.command.LimitedCommand;
import arcomat.cli.option.BrickLimitOption;
import arcomat.cli.option.CheckRendering;
import arcomat.cli.option.ClusterOptions;
import arcomat.cli.option.CommandResults;
import arcomat.cli.option.ReportFormat;
import arcomat.cli.option.ReportOptions;
import arcomat.cli.terminal.ExitStatus;
import arcomat.cli.terminal.Version;
import arcomat.pipeline.Session;
import arcomat.pipeline.WrongUse;
import arcomat.pipeline.campaign.engine.Engine;
import arcomat.pipeline.campaign.engine.Freight;
import arcomat.pipeline.check.Aside;
import arcomat.pipeline.check.CheckResult;
import arcomat.pipeline.gate.PassGate;
import arcomat.pipeline.gate.PrepareGateCampaigns;
import arcomat.pipeline.gate.RunGateCampaigns;
import arcomat.report.finding.JunitXml;
import arcomat.report.finding.Reported;
import arcomat.report.finding.Reported.Standing;
import arcomat.report.gate.GateCases;
import arcomat.report.gate.GateJson;
import arcomat.report.gate.GateText;
import arcomat.report.gate.GatedCampaigns;
import arcomat.report.text.Style;
import arcomat.source.Diagnostic;
import arcomat.source.Suppressed;

import picocli.CommandLine;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Option;
import picocli.CommandLine.Parameters;

import java.util.ArrayList;
import java.util.List;
import java.util.function.Function;
import java.util.stream.Stream;

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
            "  arcomat gate --base ../main/models --campaign meeting.campaign models",
            "  arcomat gate --base ../main/models --campaign meeting.campaign --cluster yard"
                    + " models",
            "",
            "Exit status: 0 all keep their promises, and what campaigns require holds; 1 something"
                    + " fails; 3 something is unknown; 2 wrong use, or models or campaigns with"
                    + " errors."
        })
public final class GateCommand extends LimitedCommand {
    @Mixin private ReportOptions reports = new ReportOptions();

    @Option(
            names = "--base",
            paramLabel = "DIR",
            required = true,
            description = "The same model root as it was: a checkout of main. May be repeated.")
    private List<String> base;

    @Option(
            names = "--campaign",
            paramLabel = "FILE.campaign",
            description =
                    "A campaign that has to hold as well: what it requires is asked of the models"
                            + " as they are. May be repeated.")
    private List<String> campaigns = new ArrayList<>();

    @Mixin private BrickLimitOption bricks = new BrickLimitOption();

    @Mixin private ClusterOptions clusters = new ClusterOptions();

    @Parameters(paramLabel = "PATH", arity = "1..*", description = "Model files and model roots.")
    private List<String> paths;

    /** It holds for each comparison. */
    @Override
    protected boolean isTimeOfAll() {
        return false;
    }

    /** All that the gate has found out. */
    private record Outcome(PassGate.Result result, Gate gate, RunGateCampaigns.Result runs) {
        GatedCampaigns campaigns() {
            return new GatedCampaigns(runs.reports());
        }

        Answer answer() {
            return gate.answer().and(campaigns().answer());
        }

        List<Diagnostic> findings() {
            return Stream.concat(result.findings().stream(), runs.findings().stream())
                    .sorted(Diagnostic.ORDER)
                    .toList();
        }
    }

    @Override
    protected int run(Session session) throws WrongUse {
        reports.prepare(session);
        requireCampaign("--no-limits", bricks.isGiven());
        requireCampaign("--cluster", clusters.isWanted());
        Function<Freight, Engine> engines = engines(session);
        PrepareGateCampaigns.Prepared prepared =
                session.run(new PrepareGateCampaigns(campaigns, bricks.limits(), Version.number()));
        if (prepared.check().hasErrors()) {
            tellAside(prepared.check());
            reports.write(
                    CheckRendering.refused("gate", prepared.check(), machineFormats()).results(),
                    session,
                    console());
            return ExitStatus.WRONG_USE;
        }
        PassGate.Result result = session.run(new PassGate(base, paths, limits()));
        Aside aside = result.aside().and(prepared.check().aside());
        tellAside(aside);
        if (result.gate().isEmpty()) {
            reports.write(
                    new CommandResults(
                            "gate",
                            (format, style) -> refusal(result, format, style),
                            () -> refusal(result).report().reported()),
                    session,
                    console());
            return ExitStatus.WRONG_USE;
        }
        RunGateCampaigns.Result runs =
                session.run(new RunGateCampaigns(prepared.campaigns(), engines));
        Outcome outcome = new Outcome(result, result.gate().get(), runs);
        reports.write(
                new CommandResults(
                        "gate",
                        (format, style) -> text(outcome, aside, format, style),
                        () -> reported(outcome, aside)),
                session,
                console());
        return aside.isEmpty() ? status(outcome.answer()) : ExitStatus.WRONG_USE;
    }

    private void requireCampaign(String option, boolean isGiven) throws WrongUse {
        if (isGiven && campaigns.isEmpty()) {
            throw new WrongUse(
                    "%s is about the runs of campaigns: name one, by --campaign", option);
        }
    }

    /** Who makes the runs. */
    private Function<Freight, Engine> engines(Session session) throws WrongUse {
        return clusters.isWanted()
                ? clusters.engines(session.names(), console())
                : RunGateCampaigns::onAllProcessors;
    }

    private String text(Outcome outcome, Aside aside, ReportFormat format, Style style) {
        Gate gate = outcome.gate();
        GatedCampaigns tried = outcome.campaigns();
        List<Diagnostic> findings = outcome.findings();
        return switch (format) {
            case text -> GateText.render(gate, tried, findings, style);
            case json -> GateJson.render(gate, tried, findings, aside.findings(), aside.files());
            case sarif -> machineFormats().sarif(reported(outcome, aside), false);
            case github ->
                    machineFormats()
                            .github(reported(outcome, aside), GateText.summary(gate, tried, style));
            case junit ->
                    JunitXml.render(
                            "arcomat gate",
                            CheckRendering.withCasesAside(GateCases.of(gate, tried), aside));
        };
    }

    private static List<Reported> reported(Outcome outcome, Aside aside) {
        List<Reported> all = new ArrayList<>();
        for (Diagnostic finding : outcome.findings()) {
            all.add(new Reported(finding, Standing.NEW, "", List.of()));
        }
        for (Suppressed each : outcome.result().meant()) {
            all.add(new Reported(each.finding(), Standing.SUPPRESSED, each.reason(), List.of()));
        }
        return CheckRendering.withAside(all, aside);
    }

    /** What keeps the sides from being compared: for people, which side it is. */
    private String refusal(PassGate.Result result, ReportFormat format, Style style) {
        if (format == ReportFormat.text) {
            return refusal("the base", base, result.base(), style)
                    + refusal("the new models", paths, result.check(), style);
        }
        return refusal(result).text(format, style);
    }

    private CheckRendering refusal(PassGate.Result result) {
        CheckResult both = result.base().and(result.check());
        return CheckRendering.refused("gate", both, machineFormats());
    }

    private String refusal(String side, List<String> where, CheckResult check, Style style) {
        return check.hasErrors()
                ? "%s (%s):\n".formatted(side, String.join(", ", where))
                        + CheckRendering.refused("gate", check, machineFormats())
                                .text(ReportFormat.text, style)
                : "";
    }
}
