package arcomat.pipeline;

import arcomat.diagram.DotText;
import arcomat.diagram.Graph;
import arcomat.diagram.Layout;
import arcomat.diagram.SvgText;
import arcomat.diagram.Theme;
import arcomat.model.Component;
import arcomat.model.Model;
import arcomat.source.Span;

import java.nio.charset.StandardCharsets;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.function.Function;

/** Draws models and writes the pictures, all or nothing. */
final class DiagramStep {
    private DiagramStep() {}

    static DiagramResult run(
            DiagramRequest request, List<String> paths, PathNames names, Progress progress)
            throws WrongUse {
        CheckedModels checked =
                CheckedModels.checkToRun(paths, models -> List.of(), names, progress);
        if (checked.hasErrors()) {
            return new DiagramResult(checked.result(), List.of());
        }
        Map<String, Graph> graphs = drawings(request, checked, checked.lower(progress)).graphs();
        if (graphs.isEmpty()) {
            throw new WrongUse("there is nothing to draw in " + String.join(", ", paths));
        }
        progress.step("drawing", graphs.size(), "picture");
        Function<Span, Optional<String>> links = new SourceLinks(names, request.out())::of;
        Map<String, byte[]> files = new LinkedHashMap<>();
        for (Map.Entry<String, Graph> each : graphs.entrySet()) {
            byte[] content = content(each.getValue(), request.format(), links);
            files.put(each.getKey() + "." + request.format(), content);
        }
        OutputFolder.replace(names.resolve(request.out()), request.out(), files);
        return new DiagramResult(checked.result(), List.copyOf(files.keySet()));
    }

    private static Drawings drawings(DiagramRequest request, CheckedModels checked, Model model)
            throws WrongUse {
        Drawings drawings = new Drawings(request.depth());
        for (String name : request.components()) {
            drawings.add(MainComponent.component(name, checked, model));
        }
        if (request.components().isEmpty()) {
            LoadedModels loaded = checked.loaded();
            for (Component component : model.components()) {
                if (loaded.isNamedByUser(component.span().file().path())) {
                    drawings.add(component);
                }
            }
            checked.workspace().diagrams().stream()
                    .filter(each -> loaded.isNamedByUser(each.unit().file().path()))
                    .forEach(drawings::add);
        }
        return drawings;
    }

    private static byte[] content(
            Graph graph, DiagramRequest.Format format, Function<Span, Optional<String>> links)
            throws WrongUse {
        return switch (format) {
            case svg -> bytes(SvgText.render(Layout.of(graph), Theme.ADAPTIVE, links));
            case png ->
                    PngImage.of(
                            SvgText.render(
                                    Layout.of(graph), Theme.LIGHT, place -> Optional.empty()));
            case dot -> bytes(DotText.render(graph));
        };
    }

    private static byte[] bytes(String text) {
        return text.getBytes(StandardCharsets.UTF_8);
    }
}
