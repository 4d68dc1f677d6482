package arcomat.pipeline.world;

import arcomat.pipeline.Session;
import arcomat.pipeline.Task;
import arcomat.pipeline.WrongUse;
import arcomat.pipeline.check.Aside;
import arcomat.pipeline.file.FileReader;
import arcomat.source.Diagnostic;
import arcomat.world.World;
import arcomat.world.WorldParser;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;

/**
 * Reads a world and brings the programs of its robots.
 *
 * @param file the world, as the user wrote it
 * @param runDevices whether Java files that the world names as devices may be compiled and run,
 *     which is a finding otherwise
 */
public record PrepareWorld(String file, boolean runDevices) implements Task<PreparedWorld> {
    /**
     * @throws WrongUse where the world cannot be read
     */
    @Override
    public PreparedWorld run(Session session) throws WrongUse {
        WorldParser.Parsed parsed =
                WorldParser.parse(FileReader.required("world", file, session.names()));
        if (parsed.world().isEmpty()) {
            return new PreparedWorld(parsed.findings(), Aside.NOTHING, 1, null, Map.of());
        }
        World world = parsed.world().get();
        WorldPrograms.Result programs = WorldPrograms.of(world, file, runDevices, session);
        List<Diagnostic> findings = new ArrayList<>(parsed.findings());
        findings.addAll(programs.findings());
        return new PreparedWorld(
                findings, programs.aside(), 1 + programs.files(), world, programs.equipment());
    }
}
