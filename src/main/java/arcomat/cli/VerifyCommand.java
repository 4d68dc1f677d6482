package arcomat.cli;

import arcomat.analysis.Verdict;
import arcomat.analysis.Verdict.Answer;
import arcomat.pipeline.AnalysisResult;
import arcomat.pipeline.Answered;
import arcomat.pipeline.Pipeline;
import arcomat.pipeline.WrongUse;
import arcomat.report.ObligationsText;
import arcomat.report.VerdictJson;
import arcomat.report.VerdictText;

import picocli.CommandLine;
import picocli.CommandLine.Parameters;

import java.util.List;

/** {@code arcomat verify}: whether models keep all promises that they say they keep. */
@CommandLine.Command(
        name = "verify",
        description = "Proves all that models say they keep: refines clauses, requirements.",
        footerHeading = "%nExamples:%n",
        footer = {
            "  arcomat verify models/coffee",
            "  arcomat verify --timeout 60 --format json models > verdicts.json",
            "",
            "Exit status: 0 all hold; 1 one fails; 3 one is unknown; 2 wrong use or models with"
                    + " errors."
        })
final class VerifyCommand extends AnalysisCommand {
    @Parameters(paramLabel = "PATH", arity = "1..*", description = "Model files and model roots.")
    private List<String> paths;

    VerifyCommand(Console console) {
        super(console);
    }

    @Override
    int run(Pipeline pipeline) throws WrongUse {
        AnalysisResult result = pipeline.verify(paths, limits());
        if (result.check().hasErrors()) {
            return refuse(result.check());
        }
        List<Verdict> verdicts = result.answers().stream().map(Answered::verdict).toList();
        if (isJson()) {
            List<List<String>> sides =
                    result.answers().stream().map(a -> List.of(a.left(), a.right())).toList();
            print(VerdictJson.render(sides, verdicts));
        } else {
            printText(result.answers());
            printLine(ObligationsText.summary(verdicts, console.style()));
        }
        return status(result.answer());
    }

    /** A line for each, then the failures at length. */
    private void printText(List<Answered> answers) {
        for (Answered each : answers) {
            print(ObligationsText.line(each.left(), each.right(), each.verdict(), console.style()));
        }
        for (Answered each : answers) {
            if (each.verdict().answer() == Answer.FAILS) {
                printLine("");
                print(
                        VerdictText.render(
                                each.left(), each.right(), each.verdict(), console.style()));
            }
        }
    }
}
