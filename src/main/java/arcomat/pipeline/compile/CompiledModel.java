package arcomat.pipeline.compile;

import arcomat.generate.CodeLayout;
import arcomat.generate.GeneratedFile;
import arcomat.generate.Generation;
import arcomat.generate.Generator;
import arcomat.generate.Request;
import arcomat.generate.Target;
import arcomat.generate.plan.Choosing;
import arcomat.model.Component;
import arcomat.rt.ModelError;
import arcomat.source.Diagnostic;

import java.lang.reflect.InvocationTargetException;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.Optional;

/** A component as compiled code, loaded and ready to be instantiated. Compiled once, run often. */
public record CompiledModel(
        Component component, Choosing choosing, CodeLayout layout, ClassLoader loader) {

    /**
     * Generates Java for a component and all its parts, compiles and loads it.
     *
     * @param component passes the checks of the executable profile
     * @throws TooLargeToCompile where no Java virtual machine can hold the code
     */
    public static CompiledModel of(Component component, Choosing choosing) {
        Target target = withStandIns(Target.shipped("jvm").orElseThrow());
        Request request = Request.library(component, choosing).withTrace();
        Generation generation = Generator.generate(request, target);
        if (!generation.findings().isEmpty()) {
            throw new IllegalStateException(generation.findings().get(0).message());
        }
        Map<String, String> sources = new LinkedHashMap<>();
        for (GeneratedFile file : generation.files()) {
            sources.put(file.path(), file.text());
        }
        Compilation compilation = MemoryCompiler.compile(sources, Map.of(), ClassFiles.RUNTIME);
        for (Compilation.Problem problem : compilation.problems()) {
            Optional<Diagnostic> tooLarge = OversizedCode.finding(problem, generation.layout());
            if (tooLarge.isPresent()) {
                throw new TooLargeToCompile(tooLarge.get().message());
            }
        }
        if (!compilation.problems().isEmpty()) {
            throw new IllegalStateException(compilation.problems().toString());
        }
        return new CompiledModel(
                component,
                choosing,
                generation.layout(),
                new ClassesInMemory(compilation.classes()));
    }

    /** Messages that are told apart by a text, instead of objects that nobody could make of it. */
    private static Target withStandIns(Target target) {
        return new Target(
                target.name(), Map.of(Target.DESCRIPTION, "java = stand-ins"), Optional.of(target));
    }

    /** A model that only the interpreter can run: no Java virtual machine holds its code. */
    public static final class TooLargeToCompile extends RuntimeException {
        private static final long serialVersionUID = 1L;

        TooLargeToCompile(String message) {
            super(message);
        }
    }

    /** Calls the one constructor of a class. */
    Object instantiate(String className, List<Object> arguments) {
        try {
            return loader.loadClass(className)
                    .getConstructors()[0]
                    .newInstance(arguments.toArray());
        } catch (InvocationTargetException e) {
            if (e.getCause() instanceof ModelError problem) {
                throw problem;
            }
            throw new IllegalStateException(e);
        } catch (ReflectiveOperationException e) {
            throw new IllegalStateException(e);
        }
    }

    CodeLayout.Place place(Component part) {
        return Objects.requireNonNull(layout.components().get(part.qualifiedName()));
    }

    /** The instances of a run by their path, the whole under the empty path. */
    Map<String, CodeParts.Part> parts(Object whole) {
        return CodeParts.of(component, whole, layout);
    }
}
