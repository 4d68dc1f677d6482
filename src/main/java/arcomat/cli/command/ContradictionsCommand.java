package arcomat.cli.command;

import arcomat.analysis.contradiction.Consistency;
import arcomat.cli.option.PageOption;
import arcomat.cli.terminal.Console;
import arcomat.pipeline.Pipeline;
import arcomat.pipeline.analysis.ContradictionsRequest;
import arcomat.pipeline.analysis.ContradictionsResult;
import arcomat.pipeline.step.WrongUse;
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
        footerHeading = "%nExamples:%n",
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
public final class ContradictionsCommand extends AnalysisCommand {
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

    public ContradictionsCommand(Console console) {
        super(console);
    }

    @Override
    int run(Pipeline pipeline) throws WrongUse {
        report.prepare(pipeline);
        ContradictionsResult result =
                pipeline.contradictions(
                        new ContradictionsRequest(
                                component, all, Optional.ofNullable(out), limits()),
                        paths);
        tellAside(result.check());
        if (result.found().isEmpty()) {
            return refuse(result.check());
        }
        Consistency found = result.found().get();
        report.write(
                () -> ConsistencyPage.of(result.asked().orElseThrow(), found, result.controller()),
                pipeline);
        print(
                isJson()
                        ? ConsistencyJson.render(found, result.controller(), result.file())
                        : ConsistencyText.render(
                                result.title(),
                                found,
                                result.controller(),
                                result.file(),
                                console.style()));
        return status(found.answer());
    }
}
