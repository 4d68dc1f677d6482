package arcomat.agent.tool;

import arcomat.pipeline.WrongUse;

import java.util.List;

/**
 * What did not fit into one answer.
 *
 * @param answers that have begun
 */
record RestTool(LongAnswers answers) implements Tool {
    private static final String ANSWER = "answer";
    private static final String PART = "part";

    @Override
    public String name() {
        return "rest";
    }

    @Override
    public String description() {
        return "Gives a further part of an answer that was too long for one message; the part"
                + " before says which.";
    }

    @Override
    public List<ToolParameter> parameters() {
        return List.of(
                ToolParameter.number(ANSWER, 1, Integer.MAX_VALUE, "The number of the answer.")
                        .asRequired(),
                ToolParameter.number(PART, 1, Integer.MAX_VALUE, "Which part of it.").asRequired());
    }

    @Override
    public ToolAnswer answer(ToolCall call) throws WrongUse {
        long answer = call.arguments().number(ANSWER, 1, Integer.MAX_VALUE).orElseThrow();
        long part = call.arguments().number(PART, 1, Integer.MAX_VALUE).orElseThrow();
        return answers.part(answer, part);
    }
}
