package arcomat.pipeline.brick;

import arcomat.generate.CodeLayout;
import arcomat.model.Component;
import arcomat.pipeline.Session;
import arcomat.pipeline.WrongUse;
import arcomat.pipeline.check.Asked;
import arcomat.pipeline.check.CheckedModels;
import arcomat.pipeline.check.LoweredModels;
import arcomat.pipeline.check.MainComponent;
import arcomat.pipeline.generate.BrickCode;
import arcomat.source.Diagnostic;

import java.util.Arrays;
import java.util.List;
import java.util.Map;
import java.util.Optional;

/**
 * The models that a jar was made of, as somebody says who has both: a jar tells nothing of models.
 * The program is made again, and what is not the same, byte by byte, is believed to be of others.
 *
 * @param paths model files and model roots
 * @param main the component that the jar runs, as {@code generate --main} was told; empty for the
 *     one whose program is called as the jar's
 */
public record JarModels(List<String> paths, Optional<String> main) {
    public JarModels {
        paths = List.copyOf(paths);
    }

    /**
     * What came of it.
     *
     * @param findings about the models
     * @param layout where the jar has what the models have; empty exactly where a finding says why
     *     that is not known
     */
    public record Result(List<Diagnostic> findings, Optional<CodeLayout> layout) {}

    /**
     * Looks whether a program is one of these models.
     *
     * @throws WrongUse where it is not
     */
    Result match(JarReader jar, Session session) throws WrongUse {
        Asked asked = main.map(name -> Asked.components(List.of(name))).orElse(Asked.EVERYTHING);
        CheckedModels checked = CheckedModels.checkToExamine(paths, asked, session);
        if (checked.hasErrors()) {
            return new Result(checked.findings(), Optional.empty());
        }
        LoweredModels models = checked.lower(session);
        BrickCode code = BrickCode.of(component(jar, models, session), models, session);
        if (code.jar().isEmpty()) {
            return new Result(code.findings(), Optional.empty());
        }
        BrickCode.Jar made = code.jar().get();
        requireSame(jar, JarReader.made(made.path(), made.bytes()), code.layout());
        return new Result(List.of(), Optional.of(code.layout()));
    }

    private Component component(JarReader jar, LoweredModels models, Session session)
            throws WrongUse {
        if (main.isPresent()) {
            return MainComponent.find(main.get(), models).closed();
        }
        Map<String, String> programs = BrickCode.programs(models, session);
        Optional<String> named =
                programs.keySet().stream()
                        .filter(each -> jar.main().equals(programs.get(each)))
                        .findFirst();
        return MainComponent.component(
                named.orElseThrow(
                        () ->
                                new WrongUse(
                                        "no program of these models begins in %s, as '%s' does;"
                                                + " name the component that it runs with --main",
                                        jar.main(), jar.shown())),
                models);
    }

    /** Whoever looked into objects of other classes would tell what never was. */
    private static void requireSame(JarReader jar, JarReader made, CodeLayout layout)
            throws WrongUse {
        Map<String, byte[]> theirs = jar.program().classes();
        Map<String, byte[]> own = made.program().classes();
        Optional<String> other =
                layout.components().values().stream()
                        .map(CodeLayout.Place::className)
                        .filter(own::containsKey)
                        .filter(each -> !Arrays.equals(own.get(each), theirs.get(each)))
                        .sorted()
                        .findFirst();
        if (other.isPresent()) {
            throw new WrongUse(
                    "'%s' was not made of these models as they are now, or with other options: its"
                            + " class %s is another one; 'arcomat generate --target lejos' makes it"
                            + " again",
                    jar.shown(), other.get());
        }
    }
}
