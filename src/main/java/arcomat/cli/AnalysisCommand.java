package arcomat.cli;

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

    /** Models with errors cannot be asked anything. */
    final int refuse(arcomat.pipeline.CheckResult check) {
        reportErrors(check);
        return ExitStatus.WRONG_USE;
    }
}
