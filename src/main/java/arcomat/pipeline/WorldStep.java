package arcomat.pipeline;

import arcomat.report.WorldJson;
import arcomat.source.Diagnostic;
import arcomat.source.SourceFile;
import arcomat.world.ParsedWorld;
import arcomat.world.Recording;
import arcomat.world.World;
import arcomat.world.WorldParser;

import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;

/** Reads a world, brings the programs of its robots, runs it, and writes what happened. */
final class WorldStep {
    private static final String RECORDING = "recording.json";

    private WorldStep() {}

    static WorldResult run(WorldRequest request, PathNames names, Progress progress)
            throws WrongUse {
        SourceFile file = read(request.world(), names);
        ParsedWorld parsed = WorldParser.parse(file);
        if (parsed.world().isEmpty()) {
            return new WorldResult(parsed.findings(), 1, Optional.empty());
        }
        World world = parsed.world().get();
        WorldPrograms.Result programs = WorldPrograms.of(world, request.world(), names, progress);
        List<Diagnostic> findings = new ArrayList<>(parsed.findings());
        findings.addAll(programs.findings());
        int files = 1 + programs.files();
        if (findings.stream().anyMatch(Diagnostic::isError)) {
            return new WorldResult(findings, files, Optional.empty());
        }
        if (request.report().isPresent()) {
            requireFolder(request.report().get(), names);
        }
        progress.step("running " + request.world());
        Recording recording = WorldRun.run(world, request.seed(), programs.programs());
        if (request.report().isPresent()) {
            write(recording, request.report().get(), names);
        }
        return new WorldResult(findings, files, Optional.of(recording));
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

    private static void requireFolder(String report, PathNames names) throws WrongUse {
        Path folder = names.resolve(report);
        if (Files.exists(folder) && !Files.isDirectory(folder)) {
            throw new WrongUse("'" + report + "' is a file; --report names a folder");
        }
    }

    private static void write(Recording recording, String report, PathNames names) throws WrongUse {
        byte[] json = WorldJson.render(recording).getBytes(StandardCharsets.UTF_8);
        OutputFolder.replace(names.resolve(report), report, Map.of(RECORDING, json));
    }
}
