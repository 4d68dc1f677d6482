package arcomat.cli.command.code;

import arcomat.cli.command.Command;
import arcomat.cli.option.LibraryOption;
import arcomat.pipeline.Session;
import arcomat.pipeline.WrongUse;
import arcomat.pipeline.check.CheckedAnswer;
import arcomat.pipeline.generate.GenerateCode;
import arcomat.pipeline.generate.GenerateCode.Made;
import arcomat.pipeline.generate.GenerateCode.RobotWatch;
import arcomat.pipeline.generate.RobotBuilder.BrickProgram;
import arcomat.report.brick.BrickReportText;

import picocli.CommandLine;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Option;
import picocli.CommandLine.Parameters;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;

/** {@code arcomat generate}: writes code for models, all of it or nothing. */
@CommandLine.Command(
        name = "generate",
        description = "Writes code for models, if they are fit to run.",
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
            description =
                    "Only this component, with its parts and a program for it; p.Robot(2) gives it"
                            + " arguments.")
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

    @Mixin private LibraryOption library = new LibraryOption();

    @Parameters(paramLabel = "PATH", arity = "1..*", description = "Model files and model roots.")
    private List<String> paths;

    @Override
    protected List<String> libraries() {
        return library.folders();
    }

    @Override
    protected int run(Session session) throws WrongUse {
        boolean random = choose == Choose.random;
        CheckedAnswer<Made> generated =
                session.run(
                        new GenerateCode(
                                target, out, Optional.ofNullable(main), random, monitors, paths));
        return tellWritten(generated, this::report, out);
    }

    /** Tells of each program, and returns how many files there are. */
    private int report(Made made) {
        made.robots().forEach(robot -> report(robot, made.watches()));
        return made.files().size();
    }

    private void report(BrickProgram robot, List<RobotWatch> watches) {
        String jar = out + "/" + robot.jar();
        printLine(jar + ", a program for the brick");
        watches.stream()
                .filter(watch -> watch.robot().equals(robot.component()))
                .forEach(watch -> printLine(told(watch)));
        print(BrickReportText.render(robot.report(), console().style()));
        printLine("try it: arcomat run-brick --jar " + jar);
        printLine("link it: arcomat link --jar " + jar + ", with NXJ_HOME set");
        printLine("");
    }

    private static String told(RobotWatch watch) {
        return "it watches %s for %s, and %s when that is violated"
                .formatted(
                        watch.part().isEmpty() ? "itself" : watch.part(),
                        watch.requirement(),
                        watch.goesOn() ? "goes on" : "stops");
    }
}
