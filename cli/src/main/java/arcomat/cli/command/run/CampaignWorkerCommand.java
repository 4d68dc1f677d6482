package arcomat.cli.command.run;

import arcomat.cli.command.Command;
import arcomat.cli.option.ClusterOptions;
import arcomat.cli.terminal.ExitStatus;
import arcomat.cli.terminal.Version;
import arcomat.pipeline.Session;
import arcomat.pipeline.WrongUse;
import arcomat.pipeline.campaign.engine.EngineFailure;
import arcomat.pipeline.campaign.engine.EngineLibrary;
import arcomat.pipeline.campaign.engine.EngineProvider;
import arcomat.pipeline.campaign.engine.WorkerPlan;

import picocli.CommandLine;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Option;

/** {@code arcomat campaign-worker}: makes runs for campaigns of other processes. */
@CommandLine.Command(
        name = "campaign-worker",
        description = "Makes runs for campaigns of other processes, one campaign after the other.",
        footer = {
            "  arcomat campaign-worker --cluster yard",
            "  arcomat campaign-worker --cluster yard --at lab1.example:5701 --secret yard.secret",
            "",
            "It runs until it is stopped. The programs that campaigns send are contained as the"
                    + " command world contains them.",
            "",
            "Exit status: 0 its campaign is over, with --once; 2 wrong use, or a campaign of"
                    + " another version."
        })
public final class CampaignWorkerCommand extends Command {
    @Mixin private ClusterOptions clusters = new ClusterOptions();

    @Option(
            names = "--workers",
            paramLabel = "N",
            defaultValue = "0",
            description = "Make so many runs at a time; default: as many as there are processors.")
    private int workers;

    @Option(
            names = "--once",
            description = "End with the first campaign, 10 s after it, if no other one comes.")
    private boolean once;

    @Override
    protected int run(Session session) throws WrongUse {
        if (workers < 0) {
            throw new WrongUse("--workers " + workers + " is less than 1");
        }
        int threads = workers > 0 ? workers : Runtime.getRuntime().availableProcessors();
        WorkerPlan plan =
                new WorkerPlan(clusters.meeting(session.names()), threads, Version.number(), once);
        EngineProvider provider = EngineLibrary.required();
        try {
            provider.work(plan, ClusterOptions.lines(console().out()));
        } catch (EngineFailure e) {
            throw new WrongUse("%s", String.valueOf(e.getMessage()));
        }
        return ExitStatus.FINE;
    }
}
