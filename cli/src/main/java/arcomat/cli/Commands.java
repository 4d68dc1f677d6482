package arcomat.cli;

import arcomat.cli.command.Command;
import arcomat.cli.command.code.CheckBrickCommand;
import arcomat.cli.command.code.GenerateCommand;
import arcomat.cli.command.code.LinkCommand;
import arcomat.cli.command.code.MonitorCommand;
import arcomat.cli.command.code.TestsCommand;
import arcomat.cli.command.model.CheckCommand;
import arcomat.cli.command.model.DiagramCommand;
import arcomat.cli.command.model.ExplainCommand;
import arcomat.cli.command.model.FormatCommand;
import arcomat.cli.command.model.ImportCommand;
import arcomat.cli.command.model.NewCommand;
import arcomat.cli.command.proof.AnalyzeCommand;
import arcomat.cli.command.proof.ContradictionsCommand;
import arcomat.cli.command.proof.DiffCommand;
import arcomat.cli.command.proof.EvolutionCommand;
import arcomat.cli.command.proof.GateCommand;
import arcomat.cli.command.proof.MonaCommand;
import arcomat.cli.command.proof.RefinesCommand;
import arcomat.cli.command.proof.VerifyCommand;
import arcomat.cli.command.run.CampaignCommand;
import arcomat.cli.command.run.CampaignWorkerCommand;
import arcomat.cli.command.run.RunBrickCommand;
import arcomat.cli.command.run.SimulateCommand;
import arcomat.cli.command.run.TestCommand;
import arcomat.cli.command.run.WorldCommand;
import arcomat.cli.command.serve.LanguageServerCommand;
import arcomat.cli.command.serve.LiveCommand;
import arcomat.cli.command.serve.McpCommand;
import arcomat.cli.command.shell.CompletionCommand;
import arcomat.cli.command.shell.ManualCommand;
import arcomat.cli.command.watch.WatchCommand;

import java.util.LinkedHashMap;
import java.util.Map;
import java.util.Objects;
import java.util.Set;
import java.util.function.Supplier;

/** All commands there are, in the order of their use. */
final class Commands {
    private static final Set<String> ABOUT_ALL = Set.of("completion", "manual");

    private final Map<String, Supplier<Command>> commands = new LinkedHashMap<>();

    /**
     * Each as a lambda expression, not as a reference to its constructor: Java would load every
     * command where one is asked for.
     */
    Commands() {
        add("new", () -> new NewCommand());
        add("check", () -> new CheckCommand());
        add("import", () -> new ImportCommand());
        add("watch", () -> new WatchCommand());
        add("format", () -> new FormatCommand());
        add("generate", () -> new GenerateCommand());
        add("simulate", () -> new SimulateCommand());
        add("test", () -> new TestCommand());
        add("diagram", () -> new DiagramCommand());
        add("analyze", () -> new AnalyzeCommand());
        add("refines", () -> new RefinesCommand());
        add("verify", () -> new VerifyCommand());
        add("contradictions", () -> new ContradictionsCommand());
        add("diff", () -> new DiffCommand());
        add("evolution", () -> new EvolutionCommand());
        add("gate", () -> new GateCommand());
        add("mona", () -> new MonaCommand());
        add("tests", () -> new TestsCommand());
        add("monitor", () -> new MonitorCommand());
        add("check-brick", () -> new CheckBrickCommand());
        add("run-brick", () -> new RunBrickCommand());
        add("world", () -> new WorldCommand());
        add("campaign", () -> new CampaignCommand());
        add("campaign-worker", () -> new CampaignWorkerCommand());
        add("link", () -> new LinkCommand());
        add("explain", () -> new ExplainCommand());
        add("language-server", () -> new LanguageServerCommand());
        add("live", () -> new LiveCommand());
        add("mcp", () -> new McpCommand());
        add("completion", () -> new CompletionCommand());
        add("manual", () -> new ManualCommand());
    }

    private void add(String name, Supplier<Command> command) {
        commands.put(name, command);
    }

    Set<String> names() {
        return commands.keySet();
    }

    /** The commands that one of them has to see: itself, or all where it tells of all. */
    Set<String> seenBy(String name) {
        return ABOUT_ALL.contains(name) ? names() : Set.of(name);
    }

    /**
     * @param name one of {@link #names}
     */
    Command of(String name) {
        return Objects.requireNonNull(commands.get(name), name).get();
    }
}
