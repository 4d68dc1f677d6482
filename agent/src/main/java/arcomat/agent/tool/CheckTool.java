package arcomat.agent.tool;

import arcomat.pipeline.WrongUse;
import arcomat.pipeline.check.CheckFiles;
import arcomat.pipeline.check.CheckResult;

import java.util.List;

/** What is wrong with models. */
final class CheckTool implements Tool {
    private static final String PROFILE = "profile";
    private static final String EXECUTABLE = "executable";
    private static final List<String> PROFILES = List.of("requirements", EXECUTABLE);

    @Override
    public String name() {
        return "check";
    }

    @Override
    public String description() {
        return "Reports all that is wrong with models, each finding with its code, its place, what"
                + " to do and often a repair as edits. Ask it first, and after each change.";
    }

    @Override
    public List<ToolParameter> parameters() {
        return List.of(
                ToolParameter.paths(),
                ToolParameter.choice(
                        PROFILE,
                        PROFILES,
                        "What models must fulfil; 'executable' asks for all that code needs."
                                + " Default requirements."));
    }

    @Override
    public ToolAnswer answer(ToolCall call) throws WrongUse {
        String profile = call.arguments().choice(PROFILE, PROFILES);
        CheckResult result =
                call.session().run(new CheckFiles(call.paths(), profile.equals(EXECUTABLE)));
        return new ToolAnswer(ToolAnswer.findings(result));
    }
}
