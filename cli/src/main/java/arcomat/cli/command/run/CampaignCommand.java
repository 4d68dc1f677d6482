package arcomat.cli.command.run;

import arcomat.campaign.coverage.Coverage;
import arcomat.cli.command.Command;
import arcomat.cli.option.BrickRunOptions;
import arcomat.cli.option.ClusterOptions;
import arcomat.cli.option.LibraryOption;
import arcomat.cli.option.OutputFormat;
import arcomat.cli.terminal.ExitStatus;
import arcomat.cli.terminal.Version;
import arcomat.pipeline.Session;
import arcomat.pipeline.WrongUse;
import arcomat.pipeline.campaign.CampaignPart;
import arcomat.pipeline.campaign.CompareTables;
import arcomat.pipeline.campaign.FurtherRuns;
import arcomat.pipeline.campaign.MakeCampaign;
import arcomat.pipeline.campaign.MakePart;
import arcomat.pipeline.campaign.PrepareCampaign;
import arcomat.pipeline.campaign.PrepareCampaign.Prepared;
import arcomat.pipeline.campaign.PrepareCampaign.Ready;
import arcomat.pipeline.campaign.StoredRows;
import arcomat.pipeline.campaign.WriteCampaignPage;
import arcomat.pipeline.campaign.engine.Engine;
import arcomat.pipeline.campaign.engine.Freight;
import arcomat.pipeline.campaign.engine.ThreadEngine;
import arcomat.pipeline.campaign.engine.TrialRunner;
import arcomat.pipeline.file.ReportPage;
import arcomat.report.campaign.CampaignJson;
import arcomat.report.campaign.CampaignReport;
import arcomat.report.campaign.CampaignText;
import arcomat.report.campaign.CoverageText;
import arcomat.report.campaign.RareText;
import arcomat.report.campaign.TablesText;
import arcomat.report.finding.FindingsText;

import picocli.CommandLine;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Option;
import picocli.CommandLine.Parameters;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.function.Function;

/** {@code arcomat campaign}: many runs of a world, and what they prove. */
@CommandLine.Command(
        name = "campaign",
        description = "Runs a world many times, and says what that proves.",
        footer = {
            "  arcomat campaign models/coffee/campaigns/meeting.campaign",
            "  arcomat campaign models/coffee/campaigns/meeting.campaign --out build/meeting",
            "  arcomat campaign models/coffee/campaigns/meeting.campaign --out build/meeting"
                    + " --resume",
            "  arcomat campaign models/coffee/campaigns/meeting.campaign --report build/page",
            "  arcomat campaign models/coffee/campaigns/meeting.campaign --out build/new --against"
                    + " build/old",
            "  arcomat campaign models/coffee/campaigns/meeting.campaign --part 2/3 --out part2",
            "  arcomat campaign models/coffee/campaigns/meeting.campaign --join part1 --join part2"
                    + " --join part3",
            "",
            "Exit status: 0 all that was asked for holds; 1 something fails, or there are errors"
                    + " in the campaign, its world or its models; 3 the runs do not decide it;"
                    + " 2 wrong use."
        })
public final class CampaignCommand extends Command {
    @Mixin private LibraryOption library = new LibraryOption();

    @Parameters(
            paramLabel = "FILE.campaign",
            description = "The campaign; docs/campaigns.md tells how to write one.")
    private String campaign;

    @Option(
            names = "--out",
            paramLabel = "DIR",
            defaultValue = "",
            description =
                    "Keep the table of all runs there, rows.csv and rows.parquet; also while they"
                            + " are made.")
    private String results;

    @Option(
            names = "--resume",
            description = "Go on with the rows that an interrupted campaign has left in --out.")
    private boolean resumes;

    @Option(
            names = "--part",
            paramLabel = "K/N",
            description =
                    "Make the runs of the Kth of N parts alone, and keep them in --out: other parts"
                            + " may be made elsewhere.")
    private String part;

    @Option(
            names = "--join",
            paramLabel = "DIR",
            description =
                    "Take rows that a part of this campaign, or all of it, has made from there. May"
                            + " be repeated; what is nowhere is made.")
    private List<String> parts = new ArrayList<>();

    @Option(
            names = "--against",
            paramLabel = "DIR",
            description =
                    "Compare the table in --out with the one that another campaign has kept there."
                            + " May be repeated.")
    private List<String> older = new ArrayList<>();

    @Option(
            names = "--workers",
            paramLabel = "N",
            defaultValue = "0",
            description = "Make so many runs at a time; default: as many as there are processors.")
    private int workers;

    @Option(
            names = "--report",
            paramLabel = "DIR",
            description =
                    "Write a page that shows what came of it, DIR/index.html, and the same for"
                            + " programs.")
    private String report;

    @Option(
            names = "--format",
            paramLabel = "FORMAT",
            defaultValue = "text",
            description = "How to write results: ${COMPLETION-CANDIDATES}; default text.")
    private OutputFormat format;

    @Mixin private ClusterOptions clusters = new ClusterOptions();

    @Mixin private BrickRunOptions bricks = new BrickRunOptions();

    @Override
    protected List<String> libraries() {
        return library.folders();
    }

    @Override
    protected int run(Session session) throws WrongUse {
        if (workers < 0) {
            throw new WrongUse("--workers " + workers + " is less than 1");
        }
        if (resumes && results.isEmpty()) {
            throw new WrongUse("--resume goes on with the rows in --out: name that folder, too");
        }
        if (!older.isEmpty() && results.isEmpty()) {
            throw new WrongUse("--against compares the table in --out: name that folder, too");
        }
        Optional<CampaignPart> alone = alone();
        CompareTables comparison = new CompareTables(results, older);
        comparison.requireOthers(session);
        if (report != null) {
            new ReportPage(report, session.names()).requireWritable();
        }
        Prepared prepared =
                session.run(
                        new PrepareCampaign(
                                campaign, bricks.limits(), bricks.patience(), Version.number()));
        tellAside(prepared.aside());
        tellFindings(prepared);
        if (prepared.ready().isEmpty()) {
            printLine(
                    FindingsText.summary(prepared.findings(), prepared.files(), console().style()));
            return ExitStatus.FINDINGS;
        }
        Ready ready = prepared.ready().get();
        Function<Freight, Engine> engines = engines(ready.freight(), session);
        if (alone.isPresent()) {
            return makePart(ready, alone.get(), engines, session);
        }
        MakeCampaign.Made made =
                session.run(
                        new MakeCampaign(
                                ready,
                                results,
                                resumes,
                                StoredRows.engines(parts, ready, engines, session)));
        FurtherRuns.Found further = session.run(new FurtherRuns(ready, engines));
        CampaignReport shown =
                made.report(campaign, ready, further).against(session.run(comparison));
        if (format == OutputFormat.json) {
            print(CampaignJson.render(shown));
        } else {
            tell(made, ready, shown.coverage());
            shown.worst().ifPresent(each -> print(CampaignText.found(each, ready.replay())));
            shown.rare()
                    .ifPresent(
                            each ->
                                    print(
                                            new RareText(each, ready.replay(), console().style())
                                                    .render()));
            shown.against()
                    .forEach(each -> print(new TablesText(each, console().style()).render()));
        }
        if (report != null) {
            tellPage(session.run(new WriteCampaignPage(shown, report)));
        }
        return status(shown);
    }

    /** The part that is to be made, if not all of it is. */
    private Optional<CampaignPart> alone() throws WrongUse {
        if (part == null) {
            return Optional.empty();
        }
        if (results.isEmpty()) {
            throw new WrongUse("--part keeps its rows in --out: name that folder, too");
        }
        if (report != null || format != OutputFormat.text || !parts.isEmpty() || !older.isEmpty()) {
            throw new WrongUse(
                    "--part makes rows and judges nothing: --report, --format, --join and --against"
                            + " are for the whole campaign");
        }
        return Optional.of(CampaignPart.parse(part));
    }

    private int makePart(
            Ready ready, CampaignPart only, Function<Freight, Engine> engines, Session session)
            throws WrongUse {
        MakePart.Made made = session.run(new MakePart(ready, only, results, resumes, engines));
        printLine(
                "part %d of %d: %,d runs of %s, from %d to %d, in %s"
                        .formatted(
                                only.number(),
                                only.of(),
                                made.end() - made.first(),
                                ready.world(),
                                made.first(),
                                made.end() - 1,
                                results));
        return ExitStatus.FINE;
    }

    /** What programs read has nothing else before it. */
    private void tellFindings(Prepared prepared) {
        String findings = FindingsText.render(prepared.findings(), console().style());
        if (format == OutputFormat.json && prepared.ready().isPresent()) {
            console().err().print(findings);
        } else {
            print(findings);
        }
    }

    private void tellPage(String page) {
        if (format == OutputFormat.text) {
            printLine("wrote " + page);
        }
    }

    /** Who makes the runs, of the table, of a search and of a splitting. */
    private Function<Freight, Engine> engines(Freight freight, Session session) throws WrongUse {
        if (clusters.isWanted()) {
            return clusters.engines(session.names(), console());
        }
        int threads = workers > 0 ? workers : Runtime.getRuntime().availableProcessors();
        TrialRunner runner = new TrialRunner(freight); // what it has prepared serves all of them
        return same -> new ThreadEngine(threads, runner);
    }

    private void tell(MakeCampaign.Made made, Ready ready, Coverage coverage) {
        StringBuilder head =
                new StringBuilder("%,d runs of %s".formatted(made.runs(), ready.world()));
        long seeds = ready.campaign().seeds(made.runs());
        if (seeds < made.runs()) {
            head.append(" on %,d %s".formatted(seeds, seeds == 1 ? "seed" : "seeds"));
        }
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
        print(new CampaignText(made.result(), ready.replay(), console().style()).render());
        print(new CoverageText(coverage).render());
        printLine("table " + made.table() + (results.isEmpty() ? "" : ", in " + results));
    }

    private static int status(CampaignReport shown) {
        if (shown.fails()) {
            return ExitStatus.FINDINGS;
        }
        return shown.result().isOpen() ? ExitStatus.UNKNOWN : ExitStatus.FINE;
    }
}
