package arcomat.cli.command.serve;

import arcomat.agent.AgentService;
import arcomat.agent.AgentTerms;
import arcomat.cli.command.Command;
import arcomat.cli.option.SecondsReader;
import arcomat.cli.terminal.ExitStatus;
import arcomat.cli.terminal.Version;
import arcomat.pipeline.Fence;
import arcomat.pipeline.PathNames;
import arcomat.pipeline.Session;
import arcomat.pipeline.WrongUse;

import picocli.CommandLine;
import picocli.CommandLine.Option;
import picocli.CommandLine.Parameters;

import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.util.ArrayList;
import java.util.List;

/** {@code arcomat mcp}: serves an agent. */
@CommandLine.Command(
        name = "mcp",
        description =
                "Serves an agent, which starts it and talks to it on standard input and output.",
        footer = {
            "  arcomat mcp models/coffee",
            "",
            "It speaks the Model Context Protocol, and has the tools check, explain, simulate,"
                    + " test, refines, diagram and world; docs/agents.md has the lines that tell"
                    + " agents of it. Nothing is written, and nothing outside of the model roots is"
                    + " read.",
            "",
            "Exit status: 0 the agent took its leave; 2 wrong use."
        })
public final class McpCommand extends Command {
    /** Characters; less would cut what fits on a screen. */
    private static final int SHORTEST_ANSWER = 1000;

    @Option(
            names = "--timeout",
            paramLabel = "SECONDS",
            defaultValue = "60",
            converter = SecondsReader.class,
            description = "Give up a call after that time; default 60.")
    private Duration timeout;

    @Option(
            names = "--max-answer",
            paramLabel = "N",
            defaultValue = "40000",
            description =
                    "Characters of an answer; default 40000. What is longer comes in parts, when"
                            + " it is asked for.")
    private int longest;

    @Parameters(
            paramLabel = "ROOT",
            arity = "1..*",
            description = "Model roots: folders that the agent may ask about.")
    private List<String> roots;

    @Override
    protected int run(Session session) throws WrongUse {
        if (longest < SHORTEST_ANSWER) {
            throw new WrongUse("--max-answer " + longest + " is less than " + SHORTEST_ANSWER);
        }
        PathNames fenced = new PathNames(session.names().directory(), fence(session));
        AgentTerms terms =
                new AgentTerms(
                        new Session(fenced, session.progress()).with(session.guests()),
                        roots,
                        timeout,
                        longest);
        try {
            AgentService.serve(System.in, System.out, terms, Version.number());
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
        }
        return ExitStatus.FINE;
    }

    /** Around the folders that were named, and the libraries that guests have brought. */
    private Fence fence(Session session) throws WrongUse {
        PathNames names = session.names();
        List<Path> folders = new ArrayList<>();
        for (String root : roots) {
            Path folder = names.resolve(root);
            if (!Files.isDirectory(folder)) {
                throw new WrongUse("there is no folder '" + root + "'");
            }
            folders.add(folder);
        }
        session.libraries().forEach(each -> folders.add(names.resolve(each)));
        return Fence.around(folders, roots);
    }
}
