package arcomat.cli.command.model;

import arcomat.cli.command.LimitedCommand;
import arcomat.cli.terminal.ExitStatus;
import arcomat.pipeline.Session;
import arcomat.pipeline.WrongUse;
import arcomat.pipeline.analysis.AutomatonFindings;
import arcomat.pipeline.check.CheckedAnswer;
import arcomat.pipeline.diagram.DrawDiagrams;
import arcomat.pipeline.diagram.MarkedFindings;
import arcomat.pipeline.picture.PictureFormat;

import picocli.CommandLine;
import picocli.CommandLine.Option;
import picocli.CommandLine.Parameters;

import java.util.ArrayList;
import java.util.List;

/** {@code arcomat diagram}: pictures of models. */
@CommandLine.Command(
        name = "diagram",
        description = "Draws components with their parts, automata and class diagrams.",
        footer = {
            "  arcomat diagram --out build/pictures models/coffee",
            "  arcomat diagram --component coffee.fetcher.Fetcher --out build/fetcher"
                    + " models/coffee",
            "  arcomat diagram --format png --out build/pictures models/coffee",
            "  arcomat diagram --highlight analysis --out build/pictures models/coffee",
            "",
            "The output folder is replaced as a whole. It may hold nothing that arcomat did not",
            "write. Each picture is a file by the name of what it shows; index.html shows them"
                    + " all.",
            "",
            "Files with errors, and those that need them, are left out.",
            "",
            "Exit status: 0 written; 1 models with errors; 2 wrong use, or input that cannot be"
                    + " read."
        })
public final class DiagramCommand extends LimitedCommand {
    enum Highlight {
        analysis
    }

    private static final int DEEPEST = 1000;

    @Option(
            names = "--component",
            paramLabel = "QNAME",
            description =
                    "Only this component or class diagram; may be given again. All if absent.")
    private List<String> components = new ArrayList<>();

    @Option(
            names = "--format",
            paramLabel = "FORMAT",
            defaultValue = "svg",
            description = "How to write pictures: ${COMPLETION-CANDIDATES}; default svg.")
    private PictureFormat format;

    @Option(
            names = "--highlight",
            paramLabel = "WHAT",
            description = {
                "Mark what is found: ${COMPLETION-CANDIDATES} (overlaps, inputs that are not"
                        + " handled,",
                "states never reached, and all else that 'analyze' finds)."
            })
    private Highlight highlight;

    @Option(
            names = "--depth",
            paramLabel = "N",
            description = "Show N levels of parts inside a component; all if absent.")
    private int depth = DEEPEST;

    @Option(
            names = "--out",
            paramLabel = "DIR",
            required = true,
            description = "The folder to write, which is replaced as a whole.")
    private String out;

    @Parameters(paramLabel = "PATH", arity = "1..*", description = "Model files and model roots.")
    private List<String> paths;

    /** What is found until then is drawn. */
    @Override
    protected boolean isTimeOfAll() {
        return false;
    }

    @Override
    protected int run(Session session) throws WrongUse {
        if (depth < 0) {
            throw new WrongUse("--depth " + depth + " is no number of levels");
        }
        CheckedAnswer<List<String>> drawn =
                session.run(new DrawDiagrams(components, format, out, depth, marked(), paths));
        int status = tellWritten(drawn, List::size, out);
        boolean partly = components.isEmpty() && !drawn.check().aside().isEmpty();
        return partly ? Math.max(status, ExitStatus.FINDINGS) : status;
    }

    private MarkedFindings marked() throws WrongUse {
        return highlight == null ? MarkedFindings.NONE : new AutomatonFindings(limits());
    }
}
