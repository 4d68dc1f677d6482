package arcomat.cli.command;

import arcomat.cli.terminal.Console;
import arcomat.cli.terminal.ExitStatus;
import arcomat.pipeline.Pipeline;
import arcomat.pipeline.generate.GenerationRequest;
import arcomat.pipeline.generate.GenerationResult;
import arcomat.pipeline.generate.Robot;
import arcomat.pipeline.generate.RobotWatch;
import arcomat.pipeline.step.WrongUse;
import arcomat.report.brick.BrickReportText;
import arcomat.report.finding.FindingsText;

import picocli.CommandLine;
import picocli.CommandLine.Option;
import picocli.CommandLine.Parameters;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;

/** {@code arcomat generate}: writes code for models, all of it or nothing. */
@CommandLine.Command(
        name = "generate",
        description = "Writes code for models, if they are fit to run.",
        footerHeading = "%nExamples:%n",
        footer = {
            "  arcomat generate --target jvm --out build/coffee models/coffee",
            "  arcomat generate --target jvm --out build/coffee --main coffee.fetcher.Fetcher"
                    + " models/coffee",
            "  arcomat generate --target lejos --out build/brick models/coffee",
            "  arcomat generate --target lejos --out build/brick --main coffee.fetcher.Fetcher",
            "          --monitor coffee.fig3.AvoidCrash models/coffee",
            "  arcomat generate --target templates/c --out build/c models/coffee",
            "",
            "The output folder is replaced as a whole. It may hold nothing that arcomat did not",
            "generate. Code for the JVM needs the installation's lib/arcomat-runtime-VERSION.jar"
                    + " on",
            "its class path.",
            "",
            "Exit status: 0 written; 1 models with errors; 2 wrong use, or input that cannot be"
                    + " read."
        })
public final class GenerateCommand extends Command {
    enum Choose {
        first,
        random
    }

    @Option(
            names = "--target",
            paramLabel = "TARGET",
            required = true,
            description = "What to write code for: jvm, lejos, or a folder of templates.")
    private String target;

    @Option(
            names = "--out",
            paramLabel = "DIR",
            required = true,
            description = "The folder to write, which is replaced as a whole.")
    private String out;

    @Option(
            names = "--main",
            paramLabel = "QNAME",
            description = "Only this component, with its parts and a program for it.")
    private String main;

    @Option(
            names = "--choose",
            paramLabel = "HOW",
            defaultValue = "first",
            description =
                    "What the code does where a model leaves a choice: ${COMPLETION-CANDIDATES};"
                            + " default first.")
    private Choose choose;

    @Option(
            names = "--monitor",
            paramLabel = "[PART=]Q",
            description =
                    "Programs for the brick watch themselves for the automata of component Q, on"
                            + " the part given, or on those that say that they keep Q. May be"
                            + " repeated.")
    private List<String> monitors = new ArrayList<>();

    @Parameters(paramLabel = "PATH", arity = "1..*", description = "Model files and model roots.")
    private List<String> paths;

    public GenerateCommand(Console console) {
        super(console);
    }

    @Override
    int run(Pipeline pipeline) throws WrongUse {
        GenerationRequest request =
                new GenerationRequest(
                        target, out, Optional.ofNullable(main), choose == Choose.random, monitors);
        GenerationResult result = pipeline.generate(request, paths);
        tellAside(result.check());
        if (result.check().hasErrors()) {
            return reportErrors(result.check());
        }
        print(FindingsText.render(result.check().findings(), console.style()));
        result.robots().forEach(robot -> report(robot, result.watches()));
        printLine("wrote " + FindingsText.count(result.files().size(), "file") + " to " + out);
        return ExitStatus.FINE;
    }

    private void report(Robot robot, List<RobotWatch> watches) {
        String jar = out + "/" + robot.jar();
        printLine(jar + ", a program for the brick");
        watches.stream()
                .filter(watch -> watch.robot().equals(robot.component()))
                .forEach(watch -> printLine(told(watch)));
        print(BrickReportText.render(robot.report(), console.style()));
        printLine("try it: arcomat run-brick --jar " + jar);
        printLine("link it: arcomat link --jar " + jar + ", with NXJ_HOME set");
        printLine("");
    }

    private static String told(RobotWatch watch) {
        return "it watches "
                + (watch.part().isEmpty() ? "itself" : watch.part())
                + " for "
                + watch.requirement()
                + ", and "
                + (watch.goesOn() ? "goes on" : "stops")
                + " when that is violated";
    }
}
