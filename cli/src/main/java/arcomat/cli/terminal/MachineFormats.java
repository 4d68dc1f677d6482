package arcomat.cli.terminal;

import arcomat.pipeline.Session;
import arcomat.pipeline.check.Explanations;
import arcomat.report.finding.GitHubCommands;
import arcomat.report.finding.Reported;
import arcomat.report.finding.Sarif;
import arcomat.report.finding.SourceRoot;

import java.util.List;

/** The formats that show every result as a list of findings. */
public record MachineFormats(SourceRoot root, Session session) {
    /**
     * @param session whose laws explain themselves
     */
    public static MachineFormats of(Console console, Session session) {
        String directory = console.directory().toAbsolutePath().normalize().toString();
        return new MachineFormats(new SourceRoot(directory.replace('\\', '/')), session);
    }

    /**
     * @param compared whether findings were compared with a baseline
     */
    public String sarif(List<Reported> results, boolean compared) {
        Sarif.Tool tool =
                new Sarif.Tool(Version.number(), code -> Explanations.page(code, session));
        return Sarif.render(results, compared, tool, root);
    }

    /** With a line for whoever reads the log. */
    public String github(List<Reported> results, String summary) {
        return GitHubCommands.render(results, root) + summary;
    }
}
