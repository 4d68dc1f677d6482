package arcomat.cli.command;

import java.util.List;

/** All commands there are. */
public final class Commands {
    /** In the order of their use. */
    public static final List<String> NAMES =
            List.of(
                    "check",
                    "format",
                    "generate",
                    "simulate",
                    "test",
                    "diagram",
                    "analyze",
                    "refines",
                    "verify",
                    "contradictions",
                    "diff",
                    "evolution",
                    "gate",
                    "mona",
                    "tests",
                    "monitor",
                    "check-brick",
                    "run-brick",
                    "world",
                    "campaign",
                    "campaign-worker",
                    "link",
                    "explain",
                    "language-server");

    private Commands() {}

    /**
     * The command of that name, which is one of {@link #NAMES}. A switch, not a table of
     * constructors: a table would have Java load every command where one is asked for.
     */
    public static Command of(String name) {
        return switch (name) {
            case "check" -> new CheckCommand();
            case "format" -> new FormatCommand();
            case "generate" -> new GenerateCommand();
            case "simulate" -> new SimulateCommand();
            case "test" -> new TestCommand();
            case "diagram" -> new DiagramCommand();
            case "analyze" -> new AnalyzeCommand();
            case "refines" -> new RefinesCommand();
            case "verify" -> new VerifyCommand();
            case "contradictions" -> new ContradictionsCommand();
            case "diff" -> new DiffCommand();
            case "evolution" -> new EvolutionCommand();
            case "gate" -> new GateCommand();
            case "mona" -> new MonaCommand();
            case "tests" -> new TestsCommand();
            case "monitor" -> new MonitorCommand();
            case "check-brick" -> new CheckBrickCommand();
            case "run-brick" -> new RunBrickCommand();
            case "world" -> new WorldCommand();
            case "campaign" -> new CampaignCommand();
            case "campaign-worker" -> new CampaignWorkerCommand();
            case "link" -> new LinkCommand();
            case "language-server" -> new LanguageServerCommand();
            case "explain" -> new ExplainCommand();
            default -> throw new IllegalArgumentException(name);
        };
    }
}
