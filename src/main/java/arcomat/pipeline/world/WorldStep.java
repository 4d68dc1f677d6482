package arcomat.pipeline.world;

import arcomat.pipeline.check.Aside;
import arcomat.pipeline.file.AtomicFile;
import arcomat.pipeline.file.Failures;
import arcomat.pipeline.file.FileReader;
import arcomat.pipeline.file.ReportPage;
import arcomat.pipeline.step.PathNames;
import arcomat.pipeline.step.Progress;
import arcomat.pipeline.step.WrongUse;
import arcomat.report.world.WorldJson;
import arcomat.report.world.WorldPage;
import arcomat.source.Diagnostic;
import arcomat.world.Recording;
import arcomat.world.World;
import arcomat.world.WorldParser;

import java.io.IOException;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;

/** Reads a world and brings the programs of its robots; writes what happened in it. */
public final class WorldStep {
    private static final String RECORDING = "recording.json";

    private WorldStep() {}

    /**
     * Reads a world and brings the programs of its robots.
     *
     * @param written the world's file, as the user wrote it
     * @param runDevices whether Java files that the world names may be compiled and run
     * @throws WrongUse where the file or a program cannot be had
     */
    public static PreparedWorld prepare(
            String written, boolean runDevices, PathNames names, Progress progress)
            throws WrongUse {
        WorldParser.Parsed parsed = WorldParser.parse(FileReader.required("world", written, names));
        if (parsed.world().isEmpty()) {
            return new PreparedWorld(parsed.findings(), Aside.NOTHING, 1, null, Map.of());
        }
        World world = parsed.world().get();
        WorldPrograms.Result programs =
                WorldPrograms.of(world, written, runDevices, names, progress);
        List<Diagnostic> findings = new ArrayList<>(parsed.findings());
        findings.addAll(programs.findings());
        return new PreparedWorld(
                findings, programs.aside(), 1 + programs.files(), world, programs.equipment());
    }

    /**
     * Writes the page of a run and, beside it, the recording that it plays.
     *
     * @throws WrongUse where they cannot be written
     */
    public static void write(Recording recording, String title, String folder, PathNames names)
            throws WrongUse {
        new ReportPage(folder, names).write(WorldPage.render(recording, title));
        try {
            AtomicFile.write(names.resolve(folder).resolve(RECORDING), WorldJson.render(recording));
        } catch (IOException e) {
            throw new WrongUse("cannot write to '" + folder + "': " + Failures.reason(e));
        }
    }
}
