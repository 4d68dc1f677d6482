package arcomat.pipeline.analysis;

import arcomat.analysis.contradiction.Consistency;
import arcomat.analysis.contradiction.Contradictions;
import arcomat.analysis.refinement.Promise;
import arcomat.generate.ControllerText;
import arcomat.generate.GeneratedFile;
import arcomat.model.Automaton;
import arcomat.model.Component;
import arcomat.pipeline.check.Asked;
import arcomat.pipeline.check.CheckedModels;
import arcomat.pipeline.check.PromiseReference;
import arcomat.pipeline.file.OutputFolder;
import arcomat.pipeline.step.PathNames;
import arcomat.pipeline.step.Progress;
import arcomat.pipeline.step.WrongUse;
import arcomat.rt.ModelError;
import arcomat.source.SourceFile;
import arcomat.syntax.Formatter;

import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.stream.Collectors;

/** Looks for contradictions, and writes a controller where there are none. */
public final class ContradictionsStep {
    private static final int LONGEST_REMARK = 80;

    private ContradictionsStep() {}

    public static ContradictionsResult run(
            ContradictionsRequest request, List<String> paths, PathNames names, Progress progress)
            throws WrongUse {
        CheckedModels checked =
                CheckedModels.checkToExamine(
                        paths, Asked.components(List.of(request.component())), names, progress);
        if (checked.hasErrors()) {
            return new ContradictionsResult(
                    checked.result(),
                    Optional.empty(),
                    "",
                    Optional.empty(),
                    Optional.empty(),
                    Optional.empty());
        }
        Promise promise = required(request, checked, progress);
        progress.step("looking for contradictions");
        Consistency found = find(promise, request);
        Optional<GeneratedFile> controller =
                found.controller().map(each -> text(each, promise, request.component()));
        Optional<String> written = Optional.empty();
        if (controller.isPresent() && request.out().isPresent()) {
            written = Optional.of(write(controller.get(), request.out().get(), names));
        }
        return new ContradictionsResult(
                checked.result(),
                Optional.of(found),
                promise.title(),
                Optional.of(promise),
                controller.map(GeneratedFile::text),
                written);
    }

    /** Of a decomposed component, what is asked of it and not what its parts do. */
    private static Promise required(
            ContradictionsRequest request, CheckedModels checked, Progress progress)
            throws WrongUse {
        Promise promise =
                PromiseReference.parse(request.component()).in(checked, checked.lower(progress));
        Component component = promise.component();
        return component.isComposite() && promise.automata().isEmpty()
                ? Promise.required(component, promise.arguments())
                : promise;
    }

    private static Consistency find(Promise promise, ContradictionsRequest request)
            throws WrongUse {
        try {
            return Contradictions.check(promise, request.all(), request.limits().budget());
        } catch (ModelError error) {
            throw new WrongUse(
                    "the model goes wrong before it reads anything: " + error.getMessage());
        }
    }

    private static GeneratedFile text(Component controller, Promise promise, String written) {
        String kept =
                promise.automata().stream()
                        .map(Automaton::name)
                        .filter(name -> !name.isEmpty())
                        .collect(Collectors.joining(", "));
        List<String> remarks = new ArrayList<>();
        remarks.add("Made by arcomat contradictions " + written + ".");
        if (!kept.isEmpty() && kept.length() < LONGEST_REMARK) {
            remarks.add("It keeps " + kept + ".");
        }
        GeneratedFile file = ControllerText.of(controller, remarks);
        String formatted =
                Formatter.format(new SourceFile(file.path(), file.text()))
                        .text()
                        .orElse(file.text());
        return new GeneratedFile(file.path(), formatted);
    }

    private static String write(GeneratedFile file, String out, PathNames names) throws WrongUse {
        byte[] text = file.text().getBytes(StandardCharsets.UTF_8);
        OutputFolder.replace(names.resolve(out), out, Map.of(file.path(), text));
        return out + "/" + file.path();
    }
}
