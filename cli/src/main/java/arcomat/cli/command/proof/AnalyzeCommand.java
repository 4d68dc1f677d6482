package arcomat.cli.command.proof;

import arcomat.cli.command.AnalysisCommand;
import arcomat.pipeline.Session;
import arcomat.pipeline.Task;
import arcomat.pipeline.WrongUse;
import arcomat.pipeline.analysis.AnalyzeAutomata;
import arcomat.pipeline.analysis.AnalyzeAutomata.Found;
import arcomat.pipeline.check.CheckedAnswer;
import arcomat.report.text.Style;
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
        footer = {
            "  arcomat analyze models/coffee",
            "  arcomat analyze --component coffee.fig3.AvoidCrash models/coffee",
            "  arcomat analyze --component 'coffee.parts.Timer(2)' models/coffee",
            "",
            "Exit status: 0 nothing found; 1 findings; 3 nothing found, but not everything was",
            "looked at; 2 wrong use or models with errors. A finding that is meant is declared in",
            "the model: <<suppress = \"ARC1001: reason\">>."
        })
public final class AnalyzeCommand extends AnalysisCommand<AnalyzeAutomata.Found> {
    @Option(
            names = "--component",
            paramLabel = "Q",
            description = "A component, or component#automaton; all that PATH names if absent.")
    private List<String> components = new ArrayList<>();

    @Parameters(paramLabel = "PATH", arity = "1..*", description = "Model files and model roots.")
    private List<String> paths;

    @Override
    protected Task<CheckedAnswer<Found>> task(Session session) throws WrongUse {
        return new AnalyzeAutomata(components, paths, limits());
    }

    @Override
    protected String json(Found found) {
        return ExaminationJson.render(found.examinations(), found.unexamined());
    }

    @Override
    protected String text(Found found, Style style) {
        StringBuilder out = new StringBuilder();
        found.examinations().forEach(e -> out.append(ExaminationText.render(e, style)));
        found.unexamined().forEach(e -> out.append(ExaminationText.render(e, style)).append('\n'));
        if (found.meant() > 0) {
            out.append(ExaminationText.meant(found.meant(), style)).append('\n');
        }
        return out.toString();
    }

    @Override
    protected int status(Found found) {
        return status(found.answer());
    }
}
