package arcomat.pipeline.gate;

import arcomat.campaign.Judgement;
import arcomat.campaign.statistics.Decision;
import arcomat.pipeline.Session;
import arcomat.pipeline.Task;
import arcomat.pipeline.WrongUse;
import arcomat.pipeline.campaign.FurtherRuns;
import arcomat.pipeline.campaign.MakeCampaign;
import arcomat.pipeline.campaign.PrepareCampaign;
import arcomat.pipeline.campaign.engine.Engine;
import arcomat.pipeline.campaign.engine.Freight;
import arcomat.pipeline.campaign.engine.ThreadEngine;
import arcomat.pipeline.campaign.engine.TrialRunner;
import arcomat.report.campaign.CampaignReport;
import arcomat.source.Diagnostic;

import java.util.ArrayList;
import java.util.List;
import java.util.function.Function;

/**
 * Makes the runs of campaigns that a gate names. What is searched for, or split into levels,
 * requires nothing and is left to whoever looks at the campaign itself.
 *
 * @param engines who makes the runs
 */
public record RunGateCampaigns(
        List<PrepareGateCampaigns.Named> campaigns, Function<Freight, Engine> engines)
        implements Task<RunGateCampaigns.Result> {
    private static final String NOT_SHOWN = "ARC1105";

    /**
     * What came of it.
     *
     * @param reports in the order of the campaigns
     * @param findings about what is required and is not so, or not decided; ordered
     */
    public record Result(List<CampaignReport> reports, List<Diagnostic> findings) {
        public Result {
            reports = List.copyOf(reports);
            findings = List.copyOf(findings);
        }
    }

    /**
     * @throws WrongUse where runs cannot be made
     */
    @Override
    public Result run(Session session) throws WrongUse {
        List<CampaignReport> reports = new ArrayList<>();
        List<Diagnostic> findings = new ArrayList<>();
        // The time of a gate is that of each comparison; runs have one of their own.
        Session patient = session.with(session.progress().unlimited());
        for (PrepareGateCampaigns.Named each : campaigns) {
            CampaignReport report = report(each, patient);
            reports.add(report);
            report.result().judgements().forEach(judgement -> add(judgement, findings));
        }
        findings.sort(Diagnostic.ORDER);
        return new Result(reports, findings);
    }

    private CampaignReport report(PrepareGateCampaigns.Named named, Session session)
            throws WrongUse {
        PrepareCampaign.Ready ready = named.ready();
        MakeCampaign.Made made = session.run(new MakeCampaign(ready, "", false, engines));
        return made.report(named.file(), ready, FurtherRuns.Found.nothing(ready.items()));
    }

    /** By threads of this process, one for each processor. */
    public static Engine onAllProcessors(Freight freight) {
        return new ThreadEngine(
                Runtime.getRuntime().availableProcessors(), new TrialRunner(freight));
    }

    private static void add(Judgement judgement, List<Diagnostic> findings) {
        String message =
                "%s: %s (%s)".formatted(judgement.word(), judgement.subject(), judgement.because());
        if (judgement.decision() == Decision.FAILS) {
            findings.add(Diagnostic.error(NOT_SHOWN, judgement.place(), message));
        } else if (judgement.isOpen()) {
            findings.add(Diagnostic.warning(NOT_SHOWN, judgement.place(), message));
        }
    }
}
