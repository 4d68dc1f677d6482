package arcomat.agent.tool;

import arcomat.pipeline.Session;
import arcomat.pipeline.WrongUse;
import arcomat.pipeline.check.Explanations;

import java.util.List;
import java.util.Optional;

/** Why a law exists. */
final class ExplainTool implements Tool {
    private static final String CODE = "code";

    @Override
    public String name() {
        return "explain";
    }

    @Override
    public String description() {
        return "Tells why a law exists, with a bad and a good model, as a page in Markdown; without"
                + " a code, lists all codes with their titles.";
    }

    @Override
    public List<ToolParameter> parameters() {
        return List.of(ToolParameter.text(CODE, "Code of a finding, such as ARC0104."));
    }

    @Override
    public ToolAnswer answer(ToolCall call) throws WrongUse {
        Optional<String> code = call.arguments().text(CODE);
        return new ToolAnswer(
                code.isPresent() ? page(code.get(), call.session()) : titles(call.session()));
    }

    private static String page(String code, Session session) throws WrongUse {
        return Explanations.page(code, session)
                .orElseThrow(
                        () ->
                                new WrongUse(
                                        "there is no finding with the code '%s'; without a code,"
                                                + " this tool lists all",
                                        code));
    }

    private static String titles(Session session) {
        StringBuilder text = new StringBuilder();
        Explanations.titles(session)
                .forEach((code, title) -> text.append(code + "  " + title + "\n"));
        return text.toString();
    }
}
