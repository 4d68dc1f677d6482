package arcomat.cli.command.model;

import arcomat.cli.command.Command;
import arcomat.cli.terminal.ExitStatus;
import arcomat.cli.terminal.Version;
import arcomat.pipeline.Session;
import arcomat.pipeline.WrongUse;
import arcomat.pipeline.generate.CreateProject;
import arcomat.report.finding.FindingsText;

import picocli.CommandLine;
import picocli.CommandLine.Option;
import picocli.CommandLine.Parameters;

/** {@code arcomat new}: a folder to begin with. */
@CommandLine.Command(
        name = "new",
        description = "Makes a folder to begin with: models, tests, a world, a build.",
        footer = {
            "  arcomat new mower",
            "  arcomat new mower --kind component    logic without a robot around it",
            "  arcomat new mower --kind world    two robots on one floor, and a campaign",
            "",
            "The folder NAME is made here. What is in it checks, passes its tests and runs;"
                    + " comments say what to try next. Nothing is ever overwritten.",
            "",
            "Exit status: 0 written; 2 wrong use, or somebody's files are in the way."
        })
public final class NewCommand extends Command {
    @Option(
            names = "--kind",
            paramLabel = "KIND",
            defaultValue = "robot",
            description = "What to begin with: ${COMPLETION-CANDIDATES}; default robot.")
    private CreateProject.Kind kind;

    @Parameters(
            paramLabel = "NAME",
            description = "Of the folder, its package and its robot: letters and digits.")
    private String name;

    @Override
    protected int run(Session session) throws WrongUse {
        CreateProject.Created created =
                session.run(new CreateProject(name, kind, Version.number()));
        printLine("wrote " + FindingsText.count(created.files(), "file") + " to " + name);
        printLine("");
        printLine("what to do next:");
        created.next().forEach(command -> printLine("  " + command));
        return ExitStatus.FINE;
    }
}
