package arcomat.benchmarks.network;

import arcomat.generate.Generation;
import arcomat.generate.Generator;
import arcomat.generate.Request;
import arcomat.generate.Target;
import arcomat.generate.plan.Choosing;
import arcomat.lower.Lowering;
import arcomat.model.Component;
import arcomat.source.SourceFile;
import arcomat.symbols.Workspace;
import arcomat.syntax.Parser;
import arcomat.translate.HouseLanguages;

import java.util.ArrayList;
import java.util.List;
import java.util.Set;

/** From the text of a model to its generated code, compiled and loaded. */
final class GeneratedNetwork {
    private GeneratedNetwork() {}

    static Network of(Shape shape, boolean shuffled) {
        List<SourceFile> sources = new ArrayList<>();
        generate(NetworkText.models(shape, shuffled))
                .files()
                .forEach(file -> sources.add(new SourceFile(file.path(), file.text())));
        sources.add(NetworkText.driver(shape));
        try {
            Class<?> driver = new InMemoryClasses(sources).loadClass("load.logic.Driver");
            return (Network) driver.getConstructor().newInstance();
        } catch (ReflectiveOperationException impossible) {
            throw new IllegalStateException(impossible);
        }
    }

    private static Generation generate(List<SourceFile> models) {
        Workspace workspace =
                Workspace.of(
                        models.stream()
                                .map(file -> Parser.parse(file).unit().orElseThrow())
                                .toList(),
                        Set.of(),
                        HouseLanguages.reader());
        Component net =
                Lowering.lower(workspace).components().stream()
                        .filter(component -> component.name().equals("Net"))
                        .findFirst()
                        .orElseThrow();
        return Generator.generate(
                Request.library(net, Choosing.FIRST), Target.shipped("jvm").orElseThrow());
    }
}
