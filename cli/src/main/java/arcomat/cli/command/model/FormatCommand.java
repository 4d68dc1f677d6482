package arcomat.cli.command.model;

import arcomat.cli.command.Command;
import arcomat.cli.terminal.ExitStatus;
import arcomat.pipeline.Session;
import arcomat.pipeline.WrongUse;
import arcomat.pipeline.file.FormatFiles;
import arcomat.report.finding.FindingsText;

import picocli.CommandLine;
import picocli.CommandLine.Option;
import picocli.CommandLine.Parameters;

import java.util.List;

/** {@code arcomat format}: brings files into canonical form, or says which are not. */
@CommandLine.Command(
        name = "format",
        description = "Rewrites models in canonical form. Files with errors are left alone.",
        footer = {
            "  arcomat format models/coffee             rewrites in place",
            "  arcomat format --check models/coffee     lists files that would change",
            "",
            "Exit status: 0 done; 1 models with errors, or with --check files that would change;",
            "2 wrong use, or input that cannot be read."
        })
public final class FormatCommand extends Command {
    @Option(names = "--check", description = "Change nothing; list the files that would change.")
    private boolean check;

    @Parameters(paramLabel = "PATH", arity = "1..*", description = "Model files and folders.")
    private List<String> paths;

    @Override
    protected int run(Session session) throws WrongUse {
        FormatFiles.Result result = session.run(new FormatFiles(paths, !check));
        print(FindingsText.render(result.findings(), console().style()));
        for (String path : result.changed()) {
            printLine((check ? "would change " : "changed ") + path);
        }
        printLine(summary(result));
        if (result.hasUnreadableInput()) {
            return ExitStatus.WRONG_USE;
        }
        boolean fails = !result.findings().isEmpty() || check && !result.changed().isEmpty();
        return fails ? ExitStatus.FINDINGS : ExitStatus.FINE;
    }

    private String summary(FormatFiles.Result result) {
        int changed = result.changed().size();
        String text = changed + " of " + FindingsText.count(result.files(), "file");
        return text + (check ? " would change" : " changed");
    }
}
