package arcomat.cli.command;

import arcomat.analysis.refinement.Answered;
import arcomat.cli.option.PageOption;
import arcomat.cli.terminal.Console;
import arcomat.pipeline.Pipeline;
import arcomat.pipeline.analysis.AnalysisResult;
import arcomat.pipeline.step.WrongUse;
import arcomat.report.verdict.VerdictPage;

import picocli.CommandLine;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Option;

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
            "  arcomat refines --diagram failure.svg p.New p.Old models    draws a counterexample",
            "  arcomat refines --engine mona p.New p.Old models    a second opinion",
            "  arcomat refines --report build/refines p.New p.Old models    to look at",
            "",
            "Exit status: 0 holds; 1 fails; 3 unknown; 2 wrong use or models with errors."
        })
public final class RefinesCommand extends ComparisonCommand {
    enum Engine {
        arcomat,
        mona
    }

    @Option(
            names = "--engine",
            paramLabel = "ENGINE",
            defaultValue = "arcomat",
            description = "Who decides: ${COMPLETION-CANDIDATES}; default arcomat.")
    private Engine engine;

    @Option(
            names = "--mona",
            paramLabel = "PROGRAM",
            description = "The program for '--engine mona'; default: mona, where programs are.")
    private String mona;

    @Option(
            names = "--certificate",
            paramLabel = "FILE",
            description = "Where it holds, write down why, pair by pair.")
    private String certificate;

    @Option(
            names = "--verify-certificate",
            paramLabel = "FILE",
            description = "Search nothing: verify such a file.")
    private String doubted;

    @Option(
            names = "--diagram",
            paramLabel = "FILE",
            description = "Where it fails, draw how: an .svg or .png file.")
    private String diagram;

    @Mixin private PageOption report = new PageOption();

    public RefinesCommand(Console console) {
        super(console);
    }

    @Override
    int run(Pipeline pipeline) throws WrongUse {
        if (certificate != null && doubted != null) {
            throw new WrongUse(
                    "--verify-certificate searches nothing, so there is nothing to write for"
                            + " --certificate; leave one of them out");
        }
        report.prepare(pipeline);
        AnalysisResult result = pipeline.refines(request(asked()), paths());
        tellAside(result.check());
        if (result.check().hasErrors()) {
            return refuse(result.check());
        }
        Answered answered = result.answers().get(0);
        report.write(() -> VerdictPage.of("refines", answered), pipeline);
        print(answered);
        if (diagram != null && !isJson() && !answered.verdict().trace().isEmpty()) {
            printLine("drawn in " + diagram);
        }
        return status(result.answer());
    }

    private Optional<String> asked() throws WrongUse {
        if (mona != null && engine != Engine.mona) {
            throw new WrongUse("--mona names a program, and only '--engine mona' asks it");
        }
        return engine == Engine.mona
                ? Optional.of(Optional.ofNullable(mona).orElse("mona"))
                : Optional.empty();
    }

    @Override
    Optional<String> certificate() {
        return Optional.ofNullable(certificate);
    }

    @Override
    Optional<String> diagram() {
        return Optional.ofNullable(diagram);
    }

    @Override
    Optional<String> doubted() {
        return Optional.ofNullable(doubted);
    }
}
