package arcomat.cli.command;

import arcomat.cli.terminal.Console;
import arcomat.cli.terminal.ExitStatus;
import arcomat.pipeline.Pipeline;
import arcomat.pipeline.monitor.MonitorRequest;
import arcomat.pipeline.monitor.MonitorResult;
import arcomat.pipeline.step.WrongUse;
import arcomat.report.finding.FindingsText;
import arcomat.report.run.MonitorJson;

import picocli.CommandLine;
import picocli.CommandLine.Option;
import picocli.CommandLine.Parameters;

import java.util.List;

/** {@code arcomat monitor}: classes that watch a component while it runs. */
@CommandLine.Command(
        name = "monitor",
        description = "Writes Java that watches a component while it runs, for its requirements.",
        footerHeading = "%nExamples:%n",
        footer = {
            "  arcomat monitor coffee.fig3.AvoidCrash --out build/monitor models/coffee",
            "  arcomat monitor 'p.Robot#waits' --out build/monitor models",
            "",
            "The classes need the installation's lib/arcomat-runtime-VERSION.jar on their class"
                    + " path.",
            "To watch a run of the simulator: arcomat simulate --monitor.",
            "",
            "Exit status: 0 written; 2 wrong use or models with errors."
        })
public final class MonitorCommand extends AnalysisCommand {
    @Option(
            names = "--out",
            paramLabel = "DIR",
            required = true,
            description = "The folder to write, which is replaced as a whole.")
    private String out;

    @Parameters(index = "0", paramLabel = "A", description = "A component, or component#automaton.")
    private String component;

    @Parameters(
            index = "1..*",
            arity = "1..*",
            paramLabel = "PATH",
            description = "Model files and model roots.")
    private List<String> paths;

    public MonitorCommand(Console console) {
        super(console);
    }

    @Override
    int run(Pipeline pipeline) throws WrongUse {
        limits();
        MonitorResult result = pipeline.monitor(new MonitorRequest(component, out), paths);
        tellAside(result.check());
        if (result.files().isEmpty()) {
            return refuse(result.check());
        }
        if (isJson()) {
            print(MonitorJson.render(result.className(), result.requirements(), result.files()));
            return ExitStatus.FINE;
        }
        printLine("wrote " + FindingsText.count(result.files().size(), "file") + " to " + out);
        printLine(result.className() + " watches for");
        result.requirements().forEach(requirement -> printLine("  " + requirement));
        return ExitStatus.FINE;
    }
}
