package arcomat.pipeline;

import arcomat.report.WorldJson;
import arcomat.report.WorldPage;
import arcomat.source.Diagnostic;
import arcomat.source.SourceFile;
import arcomat.world.ParsedWorld;
import arcomat.world.Recording;
import arcomat.world.World;
import arcomat.world.WorldParser;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;

/** Reads a world and brings the programs of its robots; writes what happened in it. */
final class WorldStep {
    private static final String RECORDING = "recording.json";

    private WorldStep() {}

    static PreparedWorld prepare(String written, PathNames names, Progress progress)
            throws WrongUse {
        ParsedWorld parsed = WorldParser.parse(read(written, names));
        if (parsed.world().isEmpty()) {
            return new PreparedWorld(parsed.findings(), 1, null, Map.of());
        }
        World world = parsed.world().get();
        WorldPrograms.Result programs = WorldPrograms.of(world, written, names, progress);
        List<Diagnostic> findings = new ArrayList<>(parsed.findings());
        findings.addAll(programs.findings());
        return new PreparedWorld(findings, 1 + programs.files(), world, programs.programs());
    }

    private static SourceFile read(String written, PathNames names) throws WrongUse {
        Path path = names.resolve(written);
        if (!Files.isRegularFile(path)) {
            throw new WrongUse("there is no world '" + written + "'");
        }
        FileReader.Read read = FileReader.read(path, written);
        return read.file()
                .orElseThrow(() -> new WrongUse(written + ": " + read.finding().get().message()));
    }

    static void write(Recording recording, String title, String folder, PathNames names)
            throws WrongUse {
        new ReportPage(folder, names).write(WorldPage.render(recording, title));
        try {
            AtomicFile.write(names.resolve(folder).resolve(RECORDING), WorldJson.render(recording));
        } catch (IOException e) {
            throw new WrongUse("cannot write to '" + folder + "': " + Failures.reason(e));
        }
    }
}
