package arcomat.cli;

import arcomat.pipeline.Pipeline;
import arcomat.pipeline.TestResult;
import arcomat.pipeline.WrongUse;
import arcomat.report.StreamTestJson;
import arcomat.report.StreamTestText;

import picocli.CommandLine;
import picocli.CommandLine.Option;
import picocli.CommandLine.Parameters;

import java.util.List;

/** {@code arcomat test}: runs stream tests against their models. */
@CommandLine.Command(
        name = "test",
        description = "Runs the stream tests (.mt) of models.",
        footerHeading = "%nExamples:%n",
        footer = {
            "  arcomat test models/coffee",
            "  arcomat test models/coffee/coffee/fig6/AvoidCrashTest.mt",
            "",
            "A test passes if what it expects is among the outputs that its model allows. It",
            "passes vacuously if the model allows it only because it promises nothing any more."
        })
final class TestCommand extends Command {
    @Option(
            names = "--format",
            paramLabel = "FORMAT",
            defaultValue = "text",
            description = "How to write results: ${COMPLETION-CANDIDATES}; default text.")
    private OutputFormat format;

    @Parameters(paramLabel = "PATH", arity = "1..*", description = "Suites (.mt) and model roots.")
    private List<String> paths;

    TestCommand(Console console) {
        super(console);
    }

    @Override
    int run(Pipeline pipeline) throws WrongUse {
        TestResult result = pipeline.test(paths);
        if (result.check().hasErrors()) {
            return reportErrors(result.check());
        }
        if (format == OutputFormat.json) {
            print(StreamTestJson.render(result.tests()));
        } else {
            print(StreamTestText.render(result.tests(), console.style()));
            printLine(StreamTestText.summary(result.tests(), console.style()));
        }
        return result.hasFailures() ? ExitStatus.FINDINGS : ExitStatus.FINE;
    }
}
