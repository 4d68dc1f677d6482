package arcomat.cli.command;

import arcomat.analysis.refinement.Answered;
import arcomat.cli.terminal.Console;
import arcomat.cli.terminal.ExitStatus;
import arcomat.pipeline.Pipeline;
import arcomat.pipeline.analysis.MonaResult;
import arcomat.pipeline.step.WrongUse;
import arcomat.report.verdict.MonaReport;

import picocli.CommandLine;
import picocli.CommandLine.Option;

import java.util.Optional;

/** {@code arcomat mona}: the question whether a component refines another, for the program MONA. */
@CommandLine.Command(
        name = "mona",
        description = "Writes the question whether A refines B for the program MONA.",
        footerHeading = "%nExamples:%n",
        footer = {
            "  arcomat mona coffee.fig5.AvoidCrash coffee.fig3.AvoidCrash --out figures.mona"
                    + " models/coffee",
            "  mona -q figures.mona",
            "",
            "'arcomat refines --engine mona' asks the program and tells its answer.",
            "Exit status: 0 written; 1 the interfaces do not fit; 3 not for MONA; 2 wrong use or",
            "models with errors. The file is written in the first case only."
        })
public final class MonaCommand extends ComparisonCommand {
    @Option(
            names = "--out",
            paramLabel = "FILE",
            required = true,
            description = "The file to write, which is replaced.")
    private String out;

    public MonaCommand(Console console) {
        super(console);
    }

    @Override
    int run(Pipeline pipeline) throws WrongUse {
        MonaResult result = pipeline.mona(request(Optional.empty()), out, paths());
        tellAside(result.check());
        if (result.settled().isPresent()) {
            Answered answered = result.settled().get();
            print(answered);
            return status(answered.verdict().answer());
        }
        if (result.written().isEmpty()) {
            return refuse(result.check());
        }
        MonaResult.Written written = result.written().get();
        MonaReport report =
                new MonaReport(written.file(), written.leftStates(), written.rightStates());
        print(isJson() ? report.json() : report.text());
        return ExitStatus.FINE;
    }
}
