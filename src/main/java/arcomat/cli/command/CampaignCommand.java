package arcomat.cli.command;

import arcomat.cli.option.BrickRunOptions;
import arcomat.cli.terminal.ExitStatus;
import arcomat.cli.terminal.Version;
import arcomat.pipeline.Session;
import arcomat.pipeline.WrongUse;
import arcomat.pipeline.campaign.MakeCampaign;
import arcomat.pipeline.campaign.PrepareCampaign;
import arcomat.pipeline.campaign.PrepareCampaign.Prepared;
import arcomat.pipeline.campaign.PrepareCampaign.Ready;
import arcomat.pipeline.campaign.SearchWorst;
import arcomat.pipeline.campaign.engine.Engine;
import arcomat.pipeline.campaign.engine.Freight;
import arcomat.pipeline.campaign.engine.ThreadEngine;
import arcomat.pipeline.campaign.engine.TrialRunner;
import arcomat.report.campaign.CampaignText;
import arcomat.report.finding.FindingsText;

import picocli.CommandLine;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Option;
import picocli.CommandLine.Parameters;

/** {@code arcomat campaign}: many runs of a world, and what they prove. */
@CommandLine.Command(
        name = "campaign",
        description = "Runs a world many times, and says what that proves.",
        footer = {
            "  arcomat campaign models/coffee/campaigns/meeting.campaign",
            "  arcomat campaign models/coffee/campaigns/meeting.campaign --out build/meeting",
            "  arcomat campaign models/coffee/campaigns/meeting.campaign --out build/meeting"
                    + " --resume",
            "",
            "Exit status: 0 all that was asked for holds; 1 something fails, or there are errors"
                    + " in the campaign, its world or its models; 3 the runs do not decide it;"
                    + " 2 wrong use."
        })
final class CampaignCommand extends Command {
    @Parameters(
            paramLabel = "FILE.campaign",
            description = "The campaign; docs/campaigns.md tells how to write one.")
    private String campaign;

    @Option(
            names = "--out",
            paramLabel = "DIR",
            defaultValue = "",
            description = "Keep the table of all runs there, rows.csv; also while they are made.")
    private String results;

    @Option(
            names = "--resume",
            description = "Go on with the rows that an interrupted campaign has left in --out.")
    private boolean resumes;

    @Option(
            names = "--workers",
            paramLabel = "N",
            defaultValue = "0",
            description = "Make so many runs at a time; default: as many as there are processors.")
    private int workers;

    @Mixin private BrickRunOptions bricks = new BrickRunOptions();

    @Override
    int run(Session session) throws WrongUse {
        if (workers < 0) {
            throw new WrongUse("--workers " + workers + " is less than 1");
        }
        if (resumes && results.isEmpty()) {
            throw new WrongUse("--resume goes on with the rows in --out: name that folder, too");
        }
        Prepared prepared =
                session.run(
                        new PrepareCampaign(
                                campaign, bricks.limits(), bricks.patience(), Version.number()));
        tellAside(prepared.aside());
        print(FindingsText.render(prepared.findings(), console().style()));
        if (prepared.ready().isEmpty()) {
            printLine(
                    FindingsText.summary(prepared.findings(), prepared.files(), console().style()));
            return ExitStatus.FINDINGS;
        }
        Ready ready = prepared.ready().get();
        int status =
                tell(
                        session.run(new MakeCampaign(ready, results, resumes, this::engine)),
                        ready.world());
        session.run(new SearchWorst(ready, this::engine))
                .ifPresent(found -> print(CampaignText.found(found, ready.world())));
        return status;
    }

    private Engine engine(Freight freight) {
        int threads = workers > 0 ? workers : Runtime.getRuntime().availableProcessors();
        return new ThreadEngine(threads, new TrialRunner(freight));
    }

    private int tell(MakeCampaign.Made made, String world) {
        StringBuilder head = new StringBuilder("%,d runs of %s".formatted(made.runs(), world));
        if (made.runs() < made.planned()) {
            head.append(", decided before the %,d that were planned".formatted(made.planned()));
        }
        if (made.result().impossible() > 0) {
            head.append("; %,d have no world".formatted(made.result().impossible()));
        }
        if (made.result().givenUp() > 0) {
            head.append("; %,d were given up".formatted(made.result().givenUp()));
        }
        printLine(head.append("\n").toString());
        print(new CampaignText(made.result(), world, console().style()).render());
        printLine("table " + made.table() + (results.isEmpty() ? "" : ", in " + results));
        if (made.result().fails()) {
            return ExitStatus.FINDINGS;
        }
        return made.result().isOpen() ? ExitStatus.UNKNOWN : ExitStatus.FINE;
    }
}
