package arcomat.cli.command.serve;

import arcomat.cli.command.Command;
import arcomat.cli.terminal.ExitStatus;
import arcomat.pipeline.Session;
import arcomat.pipeline.WrongUse;
import arcomat.pipeline.check.CheckedAnswer;
import arcomat.pipeline.live.WriteLivePage;
import arcomat.report.finding.FindingsText;

import picocli.CommandLine;
import picocli.CommandLine.Option;
import picocli.CommandLine.Parameters;

import java.util.List;

/** {@code arcomat live}: models on a page that checks, runs and proves them in the browser. */
@CommandLine.Command(
        name = "live",
        description =
                "Writes a page on which models are typed, seen, run and proved, in the browser.",
        footer = {
            "  arcomat live models/coffee                       writes live/index.html",
            "  arcomat live --out build/live models/coffee",
            "",
            "The page is one file. It needs no server and no network, and sends nothing: what is",
            "typed on it stays in its address. The models in their files are not changed.",
            "",
            "Exit status: 0 written; 2 wrong use, or input that cannot be read."
        })
public final class LiveCommand extends Command {
    @Option(
            names = "--out",
            paramLabel = "DIR",
            defaultValue = "live",
            description = "The folder for index.html; default live.")
    private String out;

    @Parameters(paramLabel = "PATH", arity = "1..*", description = "Model files and model roots.")
    private List<String> paths;

    @Override
    protected int run(Session session) throws WrongUse {
        CheckedAnswer<Integer> written = session.run(new WriteLivePage(out, paths));
        if (written.value().isEmpty()) {
            return reportErrors(written.check());
        }
        String files = FindingsText.count(written.value().get(), "file");
        printLine("wrote " + out + "/index.html, with " + files + "; open it in a browser");
        return ExitStatus.FINE;
    }
}
