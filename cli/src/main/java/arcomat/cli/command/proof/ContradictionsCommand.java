package arcomat.cli.command.proof;

import arcomat.cli.command.AnalysisCommand;
import arcomat.cli.option.PageOption;
import arcomat.pipeline.Session;
import arcomat.pipeline.Task;
import arcomat.pipeline.WrongUse;
import arcomat.pipeline.analysis.FindContradictions;
import arcomat.pipeline.analysis.FindContradictions.Found;
import arcomat.pipeline.check.CheckedAnswer;
import arcomat.report.text.Style;
import arcomat.report.verdict.ConsistencyJson;
import arcomat.report.verdict.ConsistencyPage;
import arcomat.report.verdict.ConsistencyText;

import picocli.CommandLine;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Option;
import picocli.CommandLine.Parameters;

import java.util.List;
import java.util.Optional;

/** {@code arcomat contradictions}: whether requirements can be kept together. */
@CommandLine.Command(
        name = "contradictions",
        description = "Looks for requirements that no system can keep together, or makes one.",
        footer = {
            "  arcomat contradictions p.Robot models",
            "  arcomat contradictions --all p.Robot models    all minimal contradicting sets",
            "  arcomat contradictions p.Robot --out build/controller models",
            "  arcomat contradictions p.Robot --report build/report models    to look at",
            "",
            "Exit status: 0 none, and a system that keeps all of them is shown; 1 a contradiction;"
                    + " 3",
            "unknown; 2 wrong use or models with errors."
        })
public final class ContradictionsCommand extends AnalysisCommand<FindContradictions.Found> {
    @Option(
            names = "--all",
            description = "Look for all minimal sets of requirements that contradict each other.")
    private boolean all;

    @Option(
            names = "--out",
            paramLabel = "DIR",
            description =
                    "Where to write a controller that keeps all requirements, as a model; the"
                            + " folder is replaced as a whole.")
    private String out;

    @Parameters(
            index = "0",
            paramLabel = "C",
            description = "A component with several automata, or with requirements.")
    private String component;

    @Parameters(
            index = "1..*",
            arity = "1..*",
            paramLabel = "PATH",
            description = "Model files and model roots.")
    private List<String> paths;

    @Mixin private PageOption report = new PageOption();

    @Override
    protected Task<CheckedAnswer<Found>> task(Session session) throws WrongUse {
        report.prepare(session);
        return new FindContradictions(component, all, Optional.ofNullable(out), paths, limits());
    }

    @Override
    protected void report(Found found, Session session) throws WrongUse {
        report.write(
                () -> ConsistencyPage.of(found.asked(), found.consistency(), found.controller()),
                session);
    }

    @Override
    protected String json(Found found) {
        return ConsistencyJson.render(
                found.consistency(), found.controller(), found.requirements(), found.file());
    }

    @Override
    protected String text(Found found, Style style) {
        return ConsistencyText.render(
                found.asked().title(), found.consistency(), found.written(), found.file(), style);
    }

    @Override
    protected int status(Found found) {
        return status(found.consistency().answer());
    }
}
