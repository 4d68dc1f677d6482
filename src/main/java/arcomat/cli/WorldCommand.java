package arcomat.cli;

import arcomat.pipeline.Pipeline;
import arcomat.pipeline.WorldRequest;
import arcomat.pipeline.WorldResult;
import arcomat.pipeline.WrongUse;
import arcomat.report.FindingsText;
import arcomat.report.WorldText;
import arcomat.world.Recording;

import picocli.CommandLine;
import picocli.CommandLine.Option;
import picocli.CommandLine.Parameters;

import java.util.Optional;

/** {@code arcomat world}: robots on a floor. */
@CommandLine.Command(
        name = "world",
        description =
                "Runs the robots of a world: their programs on simulated bricks, on one floor.",
        footerHeading = "%nExamples:%n",
        footer = {
            "  arcomat world models/coffee/world/meeting.world",
            "  arcomat world models/coffee/world/service.world --seed 7 --report build/service",
            "",
            "Exit status 1: robots collided, a program failed, or the world's goal was not reached."
        })
final class WorldCommand extends Command {
    @Parameters(
            paramLabel = "FILE.world",
            description = "The world; docs/world.md tells how to write one.")
    private String world;

    @Option(
            names = "--seed",
            paramLabel = "N",
            defaultValue = "1",
            description =
                    "Of what is drawn: noise, offsets of sensors, where robots really stand;"
                        + " default 1. The same seed gives the same run.")
    private long seed;

    @Option(
            names = "--report",
            paramLabel = "DIR",
            description = "Write what happened to this folder.")
    private String report;

    WorldCommand(Console console) {
        super(console);
    }

    @Override
    int run(Pipeline pipeline) throws WrongUse {
        WorldRequest request = new WorldRequest(world, seed, Optional.ofNullable(report));
        WorldResult result = pipeline.world(request);
        print(FindingsText.render(result.findings(), console.style()));
        if (result.recording().isEmpty()) {
            printLine(FindingsText.summary(result.findings(), result.files(), console.style()));
            return ExitStatus.FINDINGS;
        }
        Recording recording = result.recording().get();
        print(WorldText.events(recording, console.style()));
        printLine("");
        printLine(WorldText.summary(recording));
        if (report != null) {
            printLine("written to " + report);
        }
        return recording.succeeded() ? ExitStatus.FINE : ExitStatus.FINDINGS;
    }
}
