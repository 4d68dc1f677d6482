package arcomat.pipeline.analysis;

import arcomat.analysis.contradiction.Consistency;
import arcomat.analysis.contradiction.Contradictions;
import arcomat.generate.ControllerText;
import arcomat.generate.GeneratedFile;
import arcomat.model.Automaton;
import arcomat.model.Component;
import arcomat.pipeline.Session;
import arcomat.pipeline.WrongUse;
import arcomat.pipeline.check.Asked;
import arcomat.pipeline.check.LoweredModels;
import arcomat.pipeline.check.ModelQuestion;
import arcomat.pipeline.check.PromiseReference;
import arcomat.pipeline.file.OutputFolder;
import arcomat.rt.ModelError;
import arcomat.semantics.Promise;
import arcomat.source.SourceFile;
import arcomat.syntax.Formatter;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.stream.Collectors;
import java.util.stream.Stream;

/**
 * Looks for contradictions between the requirements on a component, and writes a controller where
 * there are none.
 *
 * @param component as written: {@code p.Timer(2)}, or {@code p.Robot#waits} for one automaton only
 * @param all whether all minimal contradicting subsets are wanted
 * @param out the folder for a controller, which is replaced as a whole
 */
public record FindContradictions(
        String component,
        boolean all,
        Optional<String> out,
        List<String> paths,
        AnalysisLimits limits)
        implements ModelQuestion<FindContradictions.Found> {
    private static final int LONGEST_REMARK = 80;

    /**
     * Whether requirements contradict each other.
     *
     * @param asked the requirements
     * @param controller the text of a controller that keeps them; empty where there is none
     * @param requirements the text of what it refines, where that is no component yet
     * @param file where the controller was written; empty if it was not
     */
    public record Found(
            Promise asked,
            Consistency consistency,
            Optional<String> controller,
            Optional<String> requirements,
            Optional<String> file) {
        /** All that would be written to files, one text after the other. */
        public Optional<String> written() {
            return controller.map(text -> text + requirements.map(each -> "\n" + each).orElse(""));
        }
    }

    @Override
    public Asked asked() {
        return Asked.components(List.of(component));
    }

    /**
     * @throws WrongUse where there is no such component, or the folder cannot be written
     */
    @Override
    public Found answer(LoweredModels models, Session session) throws WrongUse {
        Promise promise = PromiseReference.parse(component).automataIn(models);
        session.progress().step("looking for contradictions");
        Consistency found = find(promise);
        Optional<GeneratedFile> controller = found.controller().map(each -> text(each, promise));
        Optional<GeneratedFile> requirements =
                found.controller().flatMap(each -> requirements(each, promise, models));
        Optional<String> written = Optional.empty();
        if (controller.isPresent() && out.isPresent()) {
            Map<String, String> texts =
                    Stream.concat(controller.stream(), requirements.stream())
                            .collect(Collectors.toMap(GeneratedFile::path, GeneratedFile::text));
            OutputFolder.replaceTexts(out.get(), texts, session.names());
            written = Optional.of(out.get() + "/" + controller.get().path());
        }
        return new Found(
                promise,
                found,
                controller.map(GeneratedFile::text),
                requirements.map(GeneratedFile::text),
                written);
    }

    /** The component that a controller says it refines, where it is none of the models. */
    private Optional<GeneratedFile> requirements(
            Component controller, Promise promise, LoweredModels models) {
        Component required = promise.component();
        if (!required.isComposite() || controller.refines().isEmpty()) {
            return Optional.empty();
        }
        String name = controller.refines().get(0);
        Set<SourceFile> files =
                required.requirements().stream()
                        .map(automaton -> automaton.span().file())
                        .collect(Collectors.toSet());
        List<String> imports =
                models.checked().workspace().units().stream()
                        .filter(unit -> files.contains(unit.file()))
                        .flatMap(unit -> unit.imports().stream())
                        .map(each -> each.name().text() + (each.wildcard() ? ".*" : ""))
                        .distinct()
                        .toList();
        GeneratedFile file =
                ControllerText.required(
                        required,
                        name.substring(name.lastIndexOf('.') + 1),
                        imports,
                        List.of(
                                "Made by arcomat contradictions " + component + ".",
                                "What is asked of " + required.name() + ", without its parts."));
        return Optional.of(formatted(file));
    }

    private Consistency find(Promise promise) throws WrongUse {
        try {
            return Contradictions.check(promise, all, limits.budget());
        } catch (ModelError error) {
            throw new WrongUse(
                    "the model goes wrong before it reads anything: " + error.getMessage());
        }
    }

    private GeneratedFile text(Component controller, Promise promise) {
        String kept =
                promise.automata().stream()
                        .map(Automaton::name)
                        .filter(name -> !name.isEmpty())
                        .collect(Collectors.joining(", "));
        List<String> remarks = new ArrayList<>();
        remarks.add("Made by arcomat contradictions " + component + ".");
        if (!kept.isEmpty() && kept.length() < LONGEST_REMARK) {
            remarks.add("It keeps " + kept + ".");
        }
        return formatted(ControllerText.of(controller, remarks));
    }

    private static GeneratedFile formatted(GeneratedFile file) {
        String formatted =
                Formatter.format(new SourceFile(file.path(), file.text()))
                        .text()
                        .orElse(file.text());
        return new GeneratedFile(file.path(), formatted);
    }
}
