package arcomat.pipeline.gate;

import arcomat.campaign.Campaign;
import arcomat.pipeline.Session;
import arcomat.pipeline.Task;
import arcomat.pipeline.WrongUse;
import arcomat.pipeline.campaign.PrepareCampaign;
import arcomat.pipeline.check.Aside;
import arcomat.pipeline.check.CheckResult;
import arcomat.sim.device.Limits;
import arcomat.source.Diagnostic;

import java.util.ArrayList;
import java.util.List;

/**
 * Reads the campaigns that a gate names, and makes the programs of their robots, before anything is
 * compared.
 *
 * @param files as the user wrote them
 * @param limits those of a brick that programs meet
 * @param version of the tool
 */
public record PrepareGateCampaigns(List<String> files, Limits limits, String version)
        implements Task<PrepareGateCampaigns.Prepared> {
    /**
     * A campaign that can be run.
     *
     * @param file as the user wrote it
     */
    public record Named(String file, PrepareCampaign.Ready ready) {}

    /**
     * What came of it.
     *
     * @param campaigns those that can be run; all, if there are no errors
     * @param check errors in campaigns, worlds and models, and what programs are made without
     */
    public record Prepared(List<Named> campaigns, CheckResult check) {
        public Prepared {
            campaigns = List.copyOf(campaigns);
        }
    }

    /**
     * @throws WrongUse where a file cannot be read, or a campaign requires nothing
     */
    @Override
    public Prepared run(Session session) throws WrongUse {
        List<Named> campaigns = new ArrayList<>();
        List<Diagnostic> errors = new ArrayList<>();
        Aside aside = Aside.NOTHING;
        for (String file : files) {
            PrepareCampaign.Prepared prepared =
                    session.run(
                            new PrepareCampaign(file, limits, PrepareCampaign.PATIENCE, version));
            prepared.findings().stream().filter(Diagnostic::isError).forEach(errors::add);
            aside = aside.and(prepared.aside());
            if (prepared.ready().isPresent()) {
                requireQuestion(file, prepared.ready().get().campaign());
                campaigns.add(new Named(file, prepared.ready().get()));
            }
        }
        errors.sort(Diagnostic.ORDER);
        return new Prepared(campaigns, new CheckResult(errors, List.of(), files, aside));
    }

    /** Every change would pass. */
    private static void requireQuestion(String file, Campaign campaign) throws WrongUse {
        if (campaign.demands().isEmpty() && campaign.comparison().isEmpty()) {
            throw new WrongUse(
                    "campaign '%s' requires nothing, so every change would pass; write a line"
                            + " 'require' or 'compare' in it",
                    file);
        }
    }
}
