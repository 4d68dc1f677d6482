package arcomat.cli.command;

import arcomat.cli.option.CheckRendering;
import arcomat.cli.option.OutputFormat;
import arcomat.cli.option.ReportFormat;
import arcomat.cli.terminal.ExitStatus;
import arcomat.pipeline.Session;
import arcomat.pipeline.Task;
import arcomat.pipeline.WrongUse;
import arcomat.pipeline.check.CheckResult;
import arcomat.pipeline.check.CheckedAnswer;
import arcomat.report.text.Style;

import picocli.CommandLine.Option;

/**
 * What the commands that answer questions about models have in common.
 *
 * @param <T> the answer of models without errors
 */
public abstract class AnalysisCommand<T> extends LimitedCommand {
    @Option(
            names = "--format",
            paramLabel = "FORMAT",
            defaultValue = "text",
            description = "How to write answers: ${COMPLETION-CANDIDATES}; default text.")
    private OutputFormat format;

    /** What is asked; complains before anything is done in vain. */
    protected abstract Task<CheckedAnswer<T>> task(Session session) throws WrongUse;

    /** Writes what was asked for beside what is printed. */
    protected void report(T answer, Session session) throws WrongUse {}

    protected abstract String json(T answer);

    /**
     * The answer for people.
     *
     * @param style of the console
     */
    protected abstract String text(T answer, Style style);

    protected abstract int status(T answer);

    @Override
    protected final int run(Session session) throws WrongUse {
        CheckedAnswer<T> reply = session.run(task(session));
        tellAside(reply.check());
        boolean json = format == OutputFormat.json;
        if (reply.value().isEmpty()) {
            return refuse(reply.check(), json);
        }
        T answer = reply.value().get();
        report(answer, session);
        print(json ? json(answer) : text(answer, console().style()));
        return status(answer);
    }

    /** Models with errors cannot be asked anything: their findings are the answer. */
    private int refuse(CheckResult check, boolean json) {
        if (json) {
            print(
                    CheckRendering.refused("", check, machineFormats())
                            .text(ReportFormat.json, console().style()));
        } else {
            reportErrors(check);
        }
        return ExitStatus.WRONG_USE;
    }
}
