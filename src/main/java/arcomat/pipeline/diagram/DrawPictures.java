package arcomat.pipeline.diagram;

import arcomat.diagram.Graph;
import arcomat.pipeline.Session;
import arcomat.pipeline.WrongUse;
import arcomat.pipeline.check.Asked;
import arcomat.pipeline.check.LoweredModels;
import arcomat.pipeline.check.ModelQuestion;
import arcomat.pipeline.picture.PictureFormat;

import java.nio.charset.StandardCharsets;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;

/**
 * Draws components, automata and class diagrams, and writes nothing: the pictures are texts in SVG,
 * by the names that their files would have.
 *
 * @param components qualified names; empty for all components and class diagrams that the paths
 *     name
 * @param depth how many levels of parts are shown inside a component
 */
public record DrawPictures(List<String> components, int depth, List<String> paths)
        implements ModelQuestion<Map<String, String>> {
    @Override
    public Asked asked() {
        return components.isEmpty() ? Asked.WHAT_IS_WHOLE : Asked.components(components);
    }

    /**
     * @throws WrongUse where there is nothing to draw
     */
    @Override
    public Map<String, String> answer(LoweredModels models, Session session) throws WrongUse {
        Map<String, Graph> graphs = Drawings.of(components, depth, List.of(), models).graphs();
        if (graphs.isEmpty()) {
            throw new WrongUse("there is nothing to draw in " + String.join(", ", paths));
        }
        session.progress().step("drawing", graphs.size(), "picture");
        Map<String, String> pictures = new LinkedHashMap<>();
        for (Map.Entry<String, Graph> each : graphs.entrySet()) {
            session.progress().goOn();
            byte[] content = PictureFormat.svg.content(each.getValue(), any -> Optional.empty());
            pictures.put(
                    each.getKey() + "." + PictureFormat.svg,
                    new String(content, StandardCharsets.UTF_8));
        }
        return pictures;
    }
}
