package arcomat.agent.tool;

import java.util.List;

/** All tools there are, in the order of their use. */
public final class Toolbox {
    private Toolbox() {}

    /**
     * @param answers that are too long for one message
     */
    public static List<Tool> all(LongAnswers answers) {
        return List.of(
                new CheckTool(),
                new ExplainTool(),
                new SimulateTool(),
                new TestTool(),
                new RefinesTool(),
                new DiagramTool(),
                new WorldTool(),
                new RestTool(answers));
    }
}
