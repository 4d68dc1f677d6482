package arcomat.pipeline.diagram;

import arcomat.diagram.Graph;
import arcomat.pipeline.Session;
import arcomat.pipeline.WrongUse;
import arcomat.pipeline.check.Asked;
import arcomat.pipeline.check.LoweredModels;
import arcomat.pipeline.check.ModelQuestion;
import arcomat.pipeline.file.OutputFolder;
import arcomat.pipeline.picture.PictureFormat;
import arcomat.pipeline.picture.SourceLinks;
import arcomat.report.page.GalleryPage;
import arcomat.source.Span;

import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.function.Function;

/**
 * Draws components, automata and class diagrams, and writes the pictures, all or nothing.
 *
 * @param components qualified names; empty for all components and class diagrams that the paths
 *     name
 * @param out the folder to be written, as a whole
 * @param depth how many levels of parts are shown inside a component
 * @param marked findings about automata that are marked in the pictures
 */
public record DrawDiagrams(
        List<String> components,
        PictureFormat format,
        String out,
        int depth,
        MarkedFindings marked,
        List<String> paths)
        implements ModelQuestion<List<String>> {
    @Override
    public Asked asked() {
        return components.isEmpty() ? Asked.WHAT_IS_WHOLE : Asked.components(components);
    }

    /**
     * The paths of files in the output folder.
     *
     * @throws WrongUse where there is nothing to draw, or the folder cannot be written
     */
    @Override
    public List<String> answer(LoweredModels models, Session session) throws WrongUse {
        Map<String, Graph> graphs =
                Drawings.of(components, depth, marked.find(models, session), models).graphs();
        if (graphs.isEmpty()) {
            throw new WrongUse("there is nothing to draw in " + String.join(", ", paths));
        }
        session.progress().step("drawing", graphs.size(), "picture");
        Function<Span, Optional<String>> links = new SourceLinks(session.names(), out)::of;
        Map<String, byte[]> files = new LinkedHashMap<>();
        List<GalleryPage.Entry> shown = new ArrayList<>();
        for (Map.Entry<String, Graph> each : graphs.entrySet()) {
            String file = each.getKey() + "." + format;
            PictureFormat.Written written = format.written(each.getValue(), links);
            files.put(file, written.file());
            shown.add(new GalleryPage.Entry(file, written.embedded()));
        }
        if (format != PictureFormat.dot) {
            String title = "Pictures of " + String.join(", ", paths);
            String gallery = GalleryPage.render(title, shown);
            files.put("index.html", gallery.getBytes(StandardCharsets.UTF_8));
        }
        OutputFolder.replace(session.names().resolve(out), out, files);
        return List.copyOf(files.keySet());
    }
}
