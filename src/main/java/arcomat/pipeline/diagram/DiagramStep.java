package arcomat.pipeline.diagram;

import arcomat.analysis.automaton.Examination;
import arcomat.analysis.refinement.Promise;
import arcomat.diagram.GalleryPage;
import arcomat.diagram.Graph;
import arcomat.model.Component;
import arcomat.model.Model;
import arcomat.pipeline.analysis.AnalysisLimits;
import arcomat.pipeline.analysis.AnalyzeStep;
import arcomat.pipeline.analysis.InstancePromises;
import arcomat.pipeline.check.Asked;
import arcomat.pipeline.check.CheckedModels;
import arcomat.pipeline.check.LoadedModels;
import arcomat.pipeline.check.MainComponent;
import arcomat.pipeline.file.OutputFolder;
import arcomat.pipeline.picture.PictureFormat;
import arcomat.pipeline.picture.SourceLinks;
import arcomat.pipeline.step.PathNames;
import arcomat.pipeline.step.Progress;
import arcomat.pipeline.step.WrongUse;
import arcomat.source.Span;
import arcomat.symbols.names.DiagramSymbol;

import java.nio.charset.StandardCharsets;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.function.Function;

/** Draws models and writes the pictures, all or nothing. */
public final class DiagramStep {
    private DiagramStep() {}

    public static DiagramResult run(
            DiagramRequest request, List<String> paths, PathNames names, Progress progress)
            throws WrongUse {
        CheckedModels checked =
                CheckedModels.checkToExamine(
                        paths, Asked.components(request.components()), names, progress);
        if (checked.hasErrors()) {
            return new DiagramResult(checked.result(), List.of());
        }
        Model model = checked.lower(progress);
        List<Examination> examinations = examinations(request, checked, model, progress);
        Map<String, Graph> graphs = drawings(request, checked, model, examinations).graphs();
        if (graphs.isEmpty()) {
            throw new WrongUse("there is nothing to draw in " + String.join(", ", paths));
        }
        progress.step("drawing", graphs.size(), "picture");
        Function<Span, Optional<String>> links = new SourceLinks(names, request.out())::of;
        Map<String, byte[]> files = new LinkedHashMap<>();
        for (Map.Entry<String, Graph> each : graphs.entrySet()) {
            byte[] content = request.format().content(each.getValue(), links);
            files.put(each.getKey() + "." + request.format(), content);
        }
        if (request.format() != PictureFormat.dot) {
            String title = "Pictures of " + String.join(", ", paths);
            String gallery = GalleryPage.render(title, List.copyOf(files.keySet()));
            files.put("index.html", gallery.getBytes(StandardCharsets.UTF_8));
        }
        OutputFolder.replace(names.resolve(request.out()), request.out(), files);
        return new DiagramResult(checked.result(), List.copyOf(files.keySet()));
    }

    private static List<Examination> examinations(
            DiagramRequest request, CheckedModels checked, Model model, Progress progress) {
        if (request.highlight().isEmpty()) {
            return List.of();
        }
        List<Promise> promises = new InstancePromises(model, checked).all();
        AnalysisLimits limits = request.highlight().get();
        return AnalyzeStep.examine(promises, checked, limits, progress);
    }

    private static Drawings drawings(
            DiagramRequest request,
            CheckedModels checked,
            Model model,
            List<Examination> examinations)
            throws WrongUse {
        Drawings drawings = new Drawings(request.depth(), examinations);
        for (String name : request.components()) {
            List<DiagramSymbol> types =
                    checked.workspace().diagrams().stream()
                            .filter(each -> each.qualifiedName().equals(name))
                            .toList();
            if (types.isEmpty() || model.component(name).isPresent()) {
                drawings.add(MainComponent.component(name, checked, model));
            }
            types.forEach(drawings::add);
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
}
