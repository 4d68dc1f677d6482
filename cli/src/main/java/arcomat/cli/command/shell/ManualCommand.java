package arcomat.cli.command.shell;

import arcomat.cli.command.Command;
import arcomat.cli.terminal.ExitStatus;
import arcomat.cli.terminal.Version;
import arcomat.pipeline.Session;
import arcomat.pipeline.WrongUse;
import arcomat.pipeline.file.OutputFolder;
import arcomat.report.finding.FindingsText;

import picocli.CommandLine;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.Spec;

import java.util.Map;
import java.util.TreeMap;

/** {@code arcomat manual}: the help of all commands for the program man. */
@CommandLine.Command(
        name = "manual",
        description = "Writes a page for the program man about each command.",
        footer = {
            "  arcomat manual --out build/man/man1",
            "  man -M build/man arcomat-check",
            "",
            "The distribution has these pages in its folder share/man.",
            "",
            "Exit status: 0 written; 2 wrong use."
        })
public final class ManualCommand extends Command {
    @Spec private CommandSpec spec;

    @Option(
            names = "--out",
            paramLabel = "DIR",
            required = true,
            description = "The folder to write, which is replaced as a whole.")
    private String out;

    @Override
    protected int run(Session session) throws WrongUse {
        CommandSpec tool = spec.root();
        Map<String, String> pages = new TreeMap<>();
        pages.put(ManualPage.file(tool), ManualPage.of(tool, Version.number()));
        for (CommandLine each : tool.subcommands().values()) {
            CommandSpec command = each.getCommandSpec();
            pages.put(ManualPage.file(command), ManualPage.of(command, Version.number()));
        }
        OutputFolder.replaceTexts(out, pages, session.names());
        printLine("wrote " + FindingsText.count(pages.size(), "file") + " to " + out);
        return ExitStatus.FINE;
    }
}
