package arcomat.cli.command;

import arcomat.cli.terminal.Console;
import arcomat.pipeline.Pipeline;
import arcomat.pipeline.analysis.AnalyzeRequest;
import arcomat.pipeline.analysis.AnalyzeResult;
import arcomat.pipeline.step.WrongUse;
import arcomat.report.verdict.ExaminationJson;
import arcomat.report.verdict.ExaminationText;

import picocli.CommandLine;
import picocli.CommandLine.Option;
import picocli.CommandLine.Parameters;

import java.util.ArrayList;
import java.util.List;

/** {@code arcomat analyze}: what can be said about each automaton alone. */
@CommandLine.Command(
        name = "analyze",
        description = {
            "Looks in each automaton for overlaps, gaps, dead ends, traps and run errors.",
            "",
            "Overlaps are transitions enabled together; gaps are inputs that are not handled; dead"
                    + " ends",
            "are states never reached and transitions never taken; in a trap nothing is sent any"
                    + " more."
        },
        footerHeading = "%nExamples:%n",
        footer = {
            "  arcomat analyze models/coffee",
            "  arcomat analyze --component coffee.fig3.AvoidCrash models/coffee",
            "  arcomat analyze --component 'coffee.parts.Timer(2)' models/coffee",
            "",
            "Exit status: 0 nothing found; 1 findings; 3 nothing found, but not everything was",
            "looked at; 2 wrong use or models with errors. A finding that is meant is declared in",
            "the model: <<suppress = \"ARC1001: reason\">>."
        })
public final class AnalyzeCommand extends AnalysisCommand {
    @Option(
            names = "--component",
            paramLabel = "Q",
            description = "A component, or component#automaton; all that PATH names if absent.")
    private List<String> components = new ArrayList<>();

    @Parameters(paramLabel = "PATH", arity = "1..*", description = "Model files and model roots.")
    private List<String> paths;

    public AnalyzeCommand(Console console) {
        super(console);
    }

    @Override
    int run(Pipeline pipeline) throws WrongUse {
        AnalyzeResult result = pipeline.analyze(new AnalyzeRequest(components, limits()), paths);
        tellAside(result.check());
        if (result.check().hasErrors()) {
            return refuse(result.check());
        }
        if (isJson()) {
            print(ExaminationJson.render(result.examinations(), result.unexamined()));
        } else {
            result.examinations().forEach(e -> print(ExaminationText.render(e, console.style())));
            result.unexamined().forEach(e -> printLine(ExaminationText.render(e, console.style())));
            if (result.meant() > 0) {
                printLine(ExaminationText.meant(result.meant(), console.style()));
            }
        }
        return status(result.answer());
    }
}
