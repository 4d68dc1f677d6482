package arcomat.agent.tool;

import arcomat.pipeline.WrongUse;
import arcomat.pipeline.simulate.RunStreamTests;
import arcomat.report.run.StreamTestJson;

import java.util.List;

/** Stream tests. */
final class TestTool implements Tool {
    @Override
    public String name() {
        return "test";
    }

    @Override
    public String description() {
        return "Runs the stream tests (.mt) of models: each with its verdict, and its streams"
                + " slice by slice, expected and actual.";
    }

    @Override
    public List<ToolParameter> parameters() {
        return List.of(ToolParameter.paths());
    }

    @Override
    public ToolAnswer answer(ToolCall call) throws WrongUse {
        return ToolAnswer.of(
                call.session().run(new RunStreamTests(call.paths())), StreamTestJson::render);
    }
}
