package arcomat.pipeline.world;

import arcomat.pipeline.Session;
import arcomat.pipeline.Task;
import arcomat.pipeline.WrongUse;
import arcomat.pipeline.check.Aside;
import arcomat.pipeline.file.FileReader;
import arcomat.source.Diagnostic;
import arcomat.source.SourceFile;
import arcomat.world.World;
import arcomat.world.WorldParameter;
import arcomat.world.WorldParser;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;

/**
 * Reads a world and brings the programs of its robots.
 *
 * @param file the world, as the user wrote it
 * @param runDevices whether Java files that the world names as devices may be compiled and run,
 *     which is a finding otherwise
 * @param values of parameters of the world that are to have others than the usual ones
 */
public record PrepareWorld(String file, boolean runDevices, Map<String, String> values)
        implements Task<PreparedWorld> {
    public PrepareWorld {
        values = Map.copyOf(values);
    }

    /** With the usual values of the world's parameters. */
    public PrepareWorld(String file, boolean runDevices) {
        this(file, runDevices, Map.of());
    }

    /**
     * @throws WrongUse where the world cannot be read, or does not have a parameter
     */
    @Override
    public PreparedWorld run(Session session) throws WrongUse {
        return run(session, new ProgramCache());
    }

    /**
     * As {@link #run(Session)}, one of several worlds that share what their robots need.
     *
     * @param programs those that are there already; more are added
     * @throws WrongUse where the world cannot be read, or does not have a parameter
     */
    public PreparedWorld run(Session session, ProgramCache programs) throws WrongUse {
        return of(FileReader.required("world", file, session.names()), session, programs);
    }

    /**
     * The same for a text that has been read.
     *
     * @throws WrongUse where it does not have a parameter
     */
    public PreparedWorld of(SourceFile text, Session session, ProgramCache programs)
            throws WrongUse {
        requireParameters(text);
        WorldParser.Parsed parsed = WorldParser.parse(text, values);
        if (parsed.world().isEmpty()) {
            return new PreparedWorld(parsed.findings(), Aside.NOTHING, 1, null, Map.of());
        }
        World world = parsed.world().get();
        WorldPrograms.Result brought = WorldPrograms.of(world, file, runDevices, session, programs);
        List<Diagnostic> findings = new ArrayList<>(parsed.findings());
        findings.addAll(brought.findings());
        return new PreparedWorld(
                findings, brought.aside(), 1 + brought.files(), world, brought.equipment());
    }

    private void requireParameters(SourceFile text) throws WrongUse {
        List<String> names =
                WorldParser.parameters(text).stream().map(WorldParameter::name).toList();
        Optional<String> unknown =
                values.keySet().stream().sorted().filter(name -> !names.contains(name)).findFirst();
        if (unknown.isPresent()) {
            throw new WrongUse(
                    "'%s' has no parameter '%s'; it has %s",
                    file, unknown.get(), names.isEmpty() ? "none" : String.join(", ", names));
        }
    }
}
