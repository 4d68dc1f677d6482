package arcomat.cli;

import arcomat.model.Automaton.Completion;
import arcomat.pipeline.AnalysisResult;
import arcomat.pipeline.Answered;
import arcomat.pipeline.Pipeline;
import arcomat.pipeline.RefinesRequest;
import arcomat.pipeline.WrongUse;
import arcomat.report.VerdictJson;
import arcomat.report.VerdictText;

import picocli.CommandLine;
import picocli.CommandLine.Option;
import picocli.CommandLine.Parameters;

import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import java.util.Optional;

/** {@code arcomat refines}: whether one component keeps the promises of another. */
@CommandLine.Command(
        name = "refines",
        description = "Proves that one component keeps what another promises, or how not.",
        footerHeading = "%nExamples:%n",
        footer = {
            "  arcomat refines coffee.fig5.AvoidCrash coffee.fig3.AvoidCrash models/coffee",
            "  arcomat refines --completion ignore,ignore p.New p.Old models",
            "  arcomat refines p.Robot 'p.Robot#waits' models    one automaton of several",
            "",
            "Exit status: 0 holds; 1 fails; 3 unknown; 2 wrong use or models with errors."
        })
final class RefinesCommand extends AnalysisCommand {
    @Option(
            names = "--completion",
            paramLabel = "LEFT,RIGHT",
            description = {
                "What A and B do where no transition fits, instead of what the models say:",
                "chaos, output, ignore or error."
            })
    private String completion;

    @Parameters(index = "0", paramLabel = "A", description = "A component, or component#automaton.")
    private String left;

    @Parameters(index = "1", paramLabel = "B", description = "What A is to keep.")
    private String right;

    @Parameters(
            index = "2..*",
            arity = "1..*",
            paramLabel = "PATH",
            description = "Model files and model roots.")
    private List<String> paths;

    RefinesCommand(Console console) {
        super(console);
    }

    @Override
    int run(Pipeline pipeline) throws WrongUse {
        AnalysisResult result = pipeline.refines(request(), paths);
        if (result.answers().isEmpty()) {
            return refuse(result.check());
        }
        Answered answered = result.answers().get(0);
        print(
                isJson()
                        ? VerdictJson.render(answered.verdict())
                        : VerdictText.render(
                                answered.left(),
                                answered.right(),
                                answered.verdict(),
                                console.style()));
        return status(result.answer());
    }

    private RefinesRequest request() throws WrongUse {
        String[] sides = completion == null ? new String[0] : completion.split(",", -1);
        if (completion != null && sides.length != 2) {
            throw new WrongUse("--completion '" + completion + "' is no pair such as chaos,output");
        }
        return new RefinesRequest(
                left, right, completion(sides, 0), completion(sides, 1), limits());
    }

    private static Optional<Completion> completion(String[] sides, int side) throws WrongUse {
        if (sides.length == 0) {
            return Optional.empty();
        }
        String name = sides[side].strip();
        return Optional.of(
                Arrays.stream(Completion.values())
                        .filter(c -> c.name().toLowerCase(Locale.ROOT).equals(name))
                        .findFirst()
                        .orElseThrow(
                                () ->
                                        new WrongUse(
                                                "'"
                                                        + name
                                                        + "' is no completion; there are chaos,"
                                                        + " output, ignore and error")));
    }
}
