package arcomat.cli.command;

import arcomat.analysis.coverage.TransitionTests;
import arcomat.cli.terminal.Console;
import arcomat.pipeline.Pipeline;
import arcomat.pipeline.analysis.TransitionTestsRequest;
import arcomat.pipeline.analysis.TransitionTestsResult;
import arcomat.pipeline.step.WrongUse;
import arcomat.report.verdict.TransitionTestsJson;
import arcomat.report.verdict.TransitionTestsText;

import picocli.CommandLine;
import picocli.CommandLine.Option;
import picocli.CommandLine.Parameters;

import java.util.List;

/** {@code arcomat tests}: stream tests that take every transition of a component. */
@CommandLine.Command(
        name = "tests",
        description = "Writes stream tests that take every transition of a component.",
        footerHeading = "%nExamples:%n",
        footer = {
            "  arcomat tests coffee.fig6.AvoidCrash --out build/tests models/coffee",
            "  arcomat tests 'coffee.parts.Timer(2)' --out build/tests models/coffee",
            "  arcomat test models/coffee build/tests",
            "",
            "Exit status: 0 all that can be taken is taken; 1 nothing can be taken; 3 something"
                    + " was",
            "not taken and may yet be possible; 2 wrong use or models with errors."
        })
public final class TestsCommand extends AnalysisCommand {
    @Option(
            names = "--out",
            paramLabel = "DIR",
            required = true,
            description = "The folder to write, which is replaced as a whole.")
    private String out;

    @Parameters(index = "0", paramLabel = "A", description = "A component, or component#automaton.")
    private String component;

    @Parameters(
            index = "1..*",
            arity = "1..*",
            paramLabel = "PATH",
            description = "Model files and model roots.")
    private List<String> paths;

    public TestsCommand(Console console) {
        super(console);
    }

    @Override
    int run(Pipeline pipeline) throws WrongUse {
        TransitionTestsResult result =
                pipeline.transitionTests(
                        new TransitionTestsRequest(component, out, limits()), paths);
        tellAside(result.check());
        if (result.found().isEmpty()) {
            return refuse(result.check());
        }
        TransitionTests.Result found = result.found().get();
        print(
                isJson()
                        ? TransitionTestsJson.render(result.file(), found)
                        : TransitionTestsText.render(
                                result.title(), result.file(), found, console.style()));
        return status(found.answer());
    }
}
