package arcomat.cli.command.code;

import arcomat.cli.command.OutputCommand;
import arcomat.cli.terminal.ExitStatus;
import arcomat.pipeline.Session;
import arcomat.pipeline.Task;
import arcomat.pipeline.check.CheckedAnswer;
import arcomat.pipeline.generate.GenerateMonitor;
import arcomat.pipeline.generate.GenerateMonitor.Made;
import arcomat.report.finding.FindingsText;
import arcomat.report.run.MonitorJson;
import arcomat.report.text.Style;

import picocli.CommandLine;

/** {@code arcomat monitor}: classes that watch a component while it runs. */
@CommandLine.Command(
        name = "monitor",
        description = "Writes Java that watches a component while it runs, for its requirements.",
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
public final class MonitorCommand extends OutputCommand<GenerateMonitor.Made> {
    @Override
    protected Task<CheckedAnswer<Made>> task(Session session) {
        return new GenerateMonitor(component(), out(), paths());
    }

    @Override
    protected String json(Made made) {
        return MonitorJson.render(made.className(), made.requirements(), made.files());
    }

    @Override
    protected String text(Made made, Style style) {
        StringBuilder text = new StringBuilder();
        String files = FindingsText.count(made.files().size(), "file");
        text.append("wrote ").append(files).append(" to ").append(out()).append('\n');
        text.append(made.className()).append(" watches for\n");
        made.requirements().forEach(each -> text.append("  ").append(each).append('\n'));
        return text.toString();
    }

    @Override
    protected int status(Made made) {
        return ExitStatus.FINE;
    }
}
