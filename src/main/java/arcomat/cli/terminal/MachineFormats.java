package arcomat.cli.terminal;

import arcomat.pipeline.check.Explanations;
import arcomat.report.finding.GitHubCommands;
import arcomat.report.finding.Reported;
import arcomat.report.finding.Sarif;
import arcomat.report.finding.SourceRoot;

import java.util.List;

/** The formats that show every result as a list of findings. */
public record MachineFormats(SourceRoot root) {
    public static MachineFormats of(Console console) {
        String directory = console.directory().toAbsolutePath().normalize().toString();
        return new MachineFormats(new SourceRoot(directory.replace('\\', '/')));
    }

    /**
     * @param compared whether findings were compared with a baseline
     */
    public String sarif(List<Reported> results, boolean compared) {
        Sarif.Tool tool = new Sarif.Tool(Version.number(), Explanations::page);
        return Sarif.render(results, compared, tool, root);
    }

    /** With a line for whoever reads the log. */
    public String github(List<Reported> results, String summary) {
        return GitHubCommands.render(results, root) + summary;
    }
}
