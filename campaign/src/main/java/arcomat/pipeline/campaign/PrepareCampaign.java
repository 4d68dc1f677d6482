package arcomat.pipeline.campaign;

import arcomat.campaign.Campaign;
import arcomat.campaign.CampaignParser;
import arcomat.campaign.coverage.CoverageItems;
import arcomat.pipeline.Session;
import arcomat.pipeline.Task;
import arcomat.pipeline.WrongUse;
import arcomat.pipeline.campaign.engine.Freight;
import arcomat.pipeline.campaign.measure.Measuring;
import arcomat.pipeline.campaign.watch.WatchFreight;
import arcomat.pipeline.check.Aside;
import arcomat.pipeline.file.FileReader;
import arcomat.report.campaign.RunAgain;
import arcomat.sim.device.Limits;
import arcomat.source.Diagnostic;
import arcomat.source.SourceFile;

import java.nio.file.Path;
import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;

/**
 * Reads a campaign and its world, and makes the programs of all its runs.
 *
 * @param file the campaign, as the user wrote it
 * @param limits those of a brick that programs meet
 * @param patience what a run may take by the PC's clock, in whole seconds
 * @param version of the tool
 */
public record PrepareCampaign(String file, Limits limits, Duration patience, String version)
        implements Task<PrepareCampaign.Prepared> {
    /** What a run may take by the PC's clock where nobody says it. */
    public static final Duration PATIENCE = Duration.ofMinutes(5);

    /**
     * What came of it.
     *
     * @param findings about the campaign, its world and the models of its robots
     * @param files how many files were read
     * @param aside models that programs are made without
     * @param ready what can be run; absent where findings are in the way
     */
    public record Prepared(
            List<Diagnostic> findings, int files, Aside aside, Optional<Ready> ready) {
        public Prepared {
            findings = List.copyOf(findings);
        }
    }

    /**
     * A campaign that can be run.
     *
     * @param world path of its world, as the user would write it
     * @param items what its runs may cover
     * @param libraries model roots of others that its programs were made with
     * @param guests paths of the guests that they were made with
     */
    public record Ready(
            Campaign campaign,
            String world,
            Freight freight,
            CoverageItems items,
            List<String> libraries,
            List<String> guests) {
        public Ready {
            guests = List.copyOf(guests);
            libraries = List.copyOf(libraries);
        }

        /** How its runs are made again. */
        public RunAgain replay() {
            return new RunAgain(world, freight.limited(), libraries, guests);
        }
    }

    /**
     * @throws WrongUse where a file cannot be read
     */
    @Override
    public Prepared run(Session session) throws WrongUse {
        SourceFile text = FileReader.required("campaign", file, session.names());
        CampaignParser.Reading reading = CampaignParser.parse(text);
        if (reading.campaign().isEmpty()) {
            return new Prepared(reading.findings(), 1, Aside.NOTHING, Optional.empty());
        }
        Campaign campaign = reading.campaign().get();
        String worldFile = beside(campaign.world().file());
        SourceFile world = FileReader.required("world", worldFile, session.names());
        CampaignPrograms.Result programs = CampaignPrograms.of(campaign, world, worldFile, session);
        List<Diagnostic> findings = new ArrayList<>(programs.findings());
        findings.addAll(Measuring.of(campaign, world).findings());
        if (findings.stream().anyMatch(Diagnostic::isError)) {
            return new Prepared(findings, 1 + programs.files(), programs.aside(), Optional.empty());
        }
        WatchFreight watching = WatchFreight.of(campaign, programs.code(), world, session);
        findings.addAll(watching.findings());
        if (findings.stream().anyMatch(Diagnostic::isError)) {
            return new Prepared(findings, 1 + programs.files(), programs.aside(), Optional.empty());
        }
        CoveragePlan.Result coverage = CoveragePlan.of(watching.code());
        Freight freight =
                new Freight(
                        version,
                        text.text(),
                        world.text(),
                        limits.equals(Limits.OF_THE_BRICK),
                        patience,
                        watching.code().programs(),
                        watching.monitors(),
                        watching.joint(),
                        coverage.probes());
        return new Prepared(
                findings,
                1 + programs.files(),
                programs.aside(),
                Optional.of(
                        new Ready(
                                campaign,
                                worldFile,
                                freight,
                                coverage.items(),
                                session.libraries(),
                                session.guests().paths())));
    }

    private String beside(String written) {
        Path parent = Path.of(file).getParent();
        Path folder = parent == null ? Path.of("") : parent;
        return folder.resolve(written).normalize().toString().replace('\\', '/');
    }
}
