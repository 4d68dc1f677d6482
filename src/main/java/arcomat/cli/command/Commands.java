package arcomat.cli.command;

import java.util.LinkedHashMap;
import java.util.Map;
import java.util.function.Supplier;

/** All commands there are. */
public final class Commands {
    /** In the order of their use. */
    public static final Map<String, Supplier<Command>> BY_NAME = new LinkedHashMap<>();

    static {
        BY_NAME.put("check", CheckCommand::new);
        BY_NAME.put("format", FormatCommand::new);
        BY_NAME.put("generate", GenerateCommand::new);
        BY_NAME.put("simulate", SimulateCommand::new);
        BY_NAME.put("test", TestCommand::new);
        BY_NAME.put("diagram", DiagramCommand::new);
        BY_NAME.put("analyze", AnalyzeCommand::new);
        BY_NAME.put("refines", RefinesCommand::new);
        BY_NAME.put("verify", VerifyCommand::new);
        BY_NAME.put("contradictions", ContradictionsCommand::new);
        BY_NAME.put("diff", DiffCommand::new);
        BY_NAME.put("evolution", EvolutionCommand::new);
        BY_NAME.put("gate", GateCommand::new);
        BY_NAME.put("mona", MonaCommand::new);
        BY_NAME.put("tests", TestsCommand::new);
        BY_NAME.put("monitor", MonitorCommand::new);
        BY_NAME.put("check-brick", CheckBrickCommand::new);
        BY_NAME.put("run-brick", RunBrickCommand::new);
        BY_NAME.put("world", WorldCommand::new);
        BY_NAME.put("link", LinkCommand::new);
        BY_NAME.put("explain", ExplainCommand::new);
    }

    private Commands() {}
}
