package arcomat.agent.tool;

import arcomat.pipeline.WrongUse;
import arcomat.pipeline.diagram.DrawPictures;

import java.util.List;
import java.util.Map;
import java.util.stream.Collectors;

/** Pictures. */
final class DiagramTool implements Tool {
    private static final String COMPONENTS = "components";
    private static final String DEPTH = "depth";
    private static final int DEEPEST = 1000;

    @Override
    public String name() {
        return "diagram";
    }

    @Override
    public String description() {
        return "Draws components with their parts, automata and class diagrams, as SVG; where"
                + " there are several pictures, each stands behind a comment with its name."
                + " Pictures are long: name what to draw.";
    }

    @Override
    public List<ToolParameter> parameters() {
        return List.of(
                ToolParameter.texts(
                        COMPONENTS,
                        "Qualified names of components and class diagrams; all if absent."),
                ToolParameter.number(
                        DEPTH, 0, DEEPEST, "How many levels of parts to show; all if absent."),
                ToolParameter.paths());
    }

    @Override
    public ToolAnswer answer(ToolCall call) throws WrongUse {
        ToolArguments told = call.arguments();
        int depth = told.number(DEPTH, 0, DEEPEST).orElse((long) DEEPEST).intValue();
        return ToolAnswer.of(
                call.session().run(new DrawPictures(told.texts(COMPONENTS), depth, call.paths())),
                DiagramTool::joined);
    }

    private static String joined(Map<String, String> pictures) {
        return pictures.size() == 1
                ? String.join("", pictures.values())
                : pictures.entrySet().stream()
                        .map(each -> "<!-- " + each.getKey() + " -->\n" + each.getValue())
                        .collect(Collectors.joining());
    }
}
