package arcomat.pipeline.generate;

import arcomat.generate.Generation;
import arcomat.generate.Monitors;
import arcomat.generate.Target;
import arcomat.model.Automaton;
import arcomat.model.Component;
import arcomat.pipeline.Session;
import arcomat.pipeline.Task;
import arcomat.pipeline.WrongUse;
import arcomat.pipeline.check.Asked;
import arcomat.pipeline.check.CheckedAnswer;
import arcomat.pipeline.check.CheckedModels;
import arcomat.pipeline.compile.OversizedCode;
import arcomat.pipeline.file.OutputFolder;
import arcomat.semantics.Promise;
import arcomat.source.Diagnostic;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Objects;

/**
 * Writes classes that watch a component, all of them or none.
 *
 * @param component as written; with {@code #automaton} for one requirement of several
 * @param out the folder to write, which is replaced as a whole
 */
public record GenerateMonitor(String component, String out, List<String> paths)
        implements Task<CheckedAnswer<GenerateMonitor.Made>> {
    /**
     * What came of it.
     *
     * @param className of the class to use
     * @param requirements what it watches for, by name and line
     * @param files paths in the output folder
     */
    public record Made(String className, List<String> requirements, List<String> files) {}

    /**
     * @throws WrongUse where there is no such component, or the folder cannot be written
     */
    @Override
    public CheckedAnswer<Made> run(Session session) throws WrongUse {
        CheckedModels checked =
                CheckedModels.checkToExamine(paths, Asked.components(List.of(component)), session);
        if (checked.hasErrors()) {
            return CheckedAnswer.refused(checked.result());
        }
        Promise promise = Watches.promise(component, checked.lower(session));
        Component watched = promise.component();
        session.progress().step("generating");
        Generation generation =
                Monitors.generate(watched, promise.automata(), Target.shipped("jvm").orElseThrow());
        List<Diagnostic> problems = new ArrayList<>(generation.findings());
        problems.addAll(OversizedCode.in(generation));
        if (!problems.isEmpty()) {
            problems.addAll(0, checked.findings());
            return CheckedAnswer.refused(checked.result().with(problems));
        }
        Map<String, String> files = new LinkedHashMap<>();
        generation.files().forEach(file -> files.put(file.path(), file.text()));
        OutputFolder.replaceTexts(out, files, session.names());
        String monitor = Monitors.name(watched, promise.automata());
        return CheckedAnswer.of(
                checked.result(),
                new Made(
                        Objects.requireNonNull(generation.layout().components().get(monitor))
                                .className(),
                        promise.automata().stream().map(a -> requirement(watched, a)).toList(),
                        List.copyOf(files.keySet())));
    }

    /** In words: {@code p.Robot#waits (line 12)}. */
    static String requirement(Component required, Automaton automaton) {
        int line = automaton.span().startPosition().line();
        return required.title(automaton) + " (line " + line + ")";
    }
}
