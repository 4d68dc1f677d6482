package arcomat.cli.command;

import arcomat.cli.option.OutputFormat;
import arcomat.cli.option.ReportFormat;
import arcomat.cli.terminal.Console;
import arcomat.cli.terminal.ExitStatus;
import arcomat.pipeline.check.CheckResult;

import picocli.CommandLine.Option;

/** What the commands that answer questions about models have in common. */
abstract class AnalysisCommand extends LimitedCommand {
    @Option(
            names = "--format",
            paramLabel = "FORMAT",
            defaultValue = "text",
            description = "How to write answers: ${COMPLETION-CANDIDATES}; default text.")
    private OutputFormat format;

    AnalysisCommand(Console console) {
        super(console);
    }

    final boolean isJson() {
        return format == OutputFormat.json;
    }

    /** Models with errors cannot be asked anything: their findings are the answer. */
    final int refuse(CheckResult check) {
        if (isJson()) {
            print(
                    CheckRendering.refused("", check, console)
                            .text(ReportFormat.json, console.style()));
        } else {
            reportErrors(check);
        }
        return ExitStatus.WRONG_USE;
    }
}
