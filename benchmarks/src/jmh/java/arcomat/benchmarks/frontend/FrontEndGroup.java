package arcomat.benchmarks.frontend;

import arcomat.benchmarks.measure.Goal;
import arcomat.benchmarks.measure.Group;
import arcomat.source.Diagnostic;
import arcomat.source.SourceFile;

import java.util.List;

/** Reading and checking models beside javac. */
public final class FrontEndGroup implements Group {
    @Override
    public String name() {
        return "frontend";
    }

    @Override
    public List<Class<?>> benchmarks() {
        return List.of(FrontEndBenchmark.class, GrowthBenchmark.class);
    }

    @Override
    public List<String> prepare() {
        List<SourceFile> models = Texts.models(FrontEndBenchmark.COUNT);
        List<SourceFile> classes = Texts.classes(Texts.length(models));
        List<Diagnostic> findings = FrontEnd.check(models);
        if (!findings.isEmpty()) {
            throw new IllegalStateException("the models should be clean: " + findings.get(0));
        }
        InMemoryJavac.compile(classes);
        return List.of(
                "models: %d files, %,d bytes".formatted(models.size(), Texts.length(models)),
                "classes: %d files, %,d bytes".formatted(classes.size(), Texts.length(classes)));
    }

    @Override
    public List<Goal> goals() {
        return List.of(
                Goal.promise("check, against javac in full", "arcomatCheck", "javacFull", 0.2),
                Goal.aim("check, against javac parsing only", "arcomatCheck", "javacParse", 1),
                Goal.promise(
                                "cost per model, 10,000 against 100 models",
                                "growth 10000",
                                "growth 100",
                                1.3)
                        .times(0.01));
    }
}
