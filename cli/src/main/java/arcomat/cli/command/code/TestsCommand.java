package arcomat.cli.command.code;

import arcomat.cli.command.OutputCommand;
import arcomat.pipeline.Session;
import arcomat.pipeline.Task;
import arcomat.pipeline.WrongUse;
import arcomat.pipeline.analysis.WriteTransitionTests;
import arcomat.pipeline.analysis.WriteTransitionTests.Made;
import arcomat.pipeline.check.CheckedAnswer;
import arcomat.report.text.Style;
import arcomat.report.verdict.TransitionTestsJson;
import arcomat.report.verdict.TransitionTestsText;

import picocli.CommandLine;

/** {@code arcomat tests}: stream tests that take every transition of a component. */
@CommandLine.Command(
        name = "tests",
        description = "Writes stream tests that take every transition of a component.",
        footer = {
            "  arcomat tests coffee.fig6.AvoidCrash --out build/tests models/coffee",
            "  arcomat tests 'coffee.parts.Timer(2)' --out build/tests models/coffee",
            "  arcomat test models/coffee build/tests",
            "",
            "Exit status: 0 all that can be taken is taken; 1 nothing can be taken; 3 something"
                    + " was",
            "not taken and may yet be possible; 2 wrong use or models with errors."
        })
public final class TestsCommand extends OutputCommand<WriteTransitionTests.Made> {
    @Override
    protected Task<CheckedAnswer<Made>> task(Session session) throws WrongUse {
        return new WriteTransitionTests(component(), out(), paths(), limits());
    }

    @Override
    protected String json(Made made) {
        return TransitionTestsJson.render(made.file(), made.tests());
    }

    @Override
    protected String text(Made made, Style style) {
        return TransitionTestsText.render(made.title(), made.file(), made.tests(), style);
    }

    @Override
    protected int status(Made made) {
        return status(made.tests().answer());
    }
}
