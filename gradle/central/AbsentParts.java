import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.TreeSet;

import javax.tools.ToolProvider;

/** Stands in for what the shaded jar lacks and a running Gradle asks for. */
final class AbsentParts {
    /** Modules that Gradle's own code asks for; others are named by modules. */
    private static final List<String> MODULES =
            List.of(
                    "gradle-installation-beacon",
                    "gradle-instrumentation-agent",
                    "gradle-kotlin-dsl",
                    "gradle-kotlin-dsl-provider-plugins",
                    "gradle-kotlin-dsl-tooling-builders",
                    "gradle-java-compiler-plugin");

    /** The javac plugin behind incremental compilation; this one passes through. */
    private static final String INCREMENTAL_COMPILE_TASK =
            """
            import java.io.File;
            import java.util.*;
            import java.util.function.*;
            import javax.tools.JavaCompiler;

            public class IncrementalCompileTask implements JavaCompiler.CompilationTask {
                private final JavaCompiler.CompilationTask task;

                public IncrementalCompileTask(
                        JavaCompiler.CompilationTask task,
                        Function<File, Optional<String>> relativize,
                        Consumer<String> classNames,
                        Consumer<Map<String, Set<String>>> classNameLists,
                        BiConsumer<String, String> publicDependents,
                        BiConsumer<String, String> privateDependents) {
                    this.task = task;
                }

                /** For older versions. */
                public IncrementalCompileTask(
                        JavaCompiler.CompilationTask task,
                        Function<File, Optional<String>> relativize,
                        Consumer<Map<String, Set<String>>> classNameLists,
                        BiConsumer<String, String> publicDependents,
                        BiConsumer<String, String> privateDependents) {
                    this.task = task;
                }

                public void addModules(Iterable<String> names) {
                    throw new UnsupportedOperationException();
                }

                public void setProcessors(
                        Iterable<? extends javax.annotation.processing.Processor> processors) {
                    task.setProcessors(processors);
                }

                public void setLocale(Locale locale) {
                    task.setLocale(locale);
                }

                public Boolean call() {
                    return task.call();
                }
            }
            """;

    private AbsentParts() {}

    static void addTo(Distribution distribution) throws IOException {
        addModules(distribution);
        addClass(
                distribution.module("gradle-installation-beacon"),
                "org.gradle.internal.installation.beacon.InstallationBeacon",
                "public class InstallationBeacon {}");
        addClass(
                distribution.module("gradle-java-compiler-plugin"),
                "org.gradle.internal.compiler.java.IncrementalCompileTask",
                INCREMENTAL_COMPILE_TASK);
        for (String jar : distribution.libraryJars()) {
            if (jar.startsWith("kotlin-stdlib-")) {
                String kotlin = jar.replaceAll("kotlin-stdlib-|\\.jar", "");
                distribution
                        .module("gradle-kotlin-dsl")
                        .put(
                                "gradle-kotlin-dsl-versions.properties",
                                Distribution.bytes("kotlin=" + kotlin + "\n"));
            }
        }
    }

    /** Modules that are named somewhere and not there become empty ones. */
    private static void addModules(Distribution distribution) throws IOException {
        Set<String> wanted = new TreeSet<>(MODULES);
        wanted.addAll(distribution.plugins());
        for (String module : distribution.modules.keySet()) {
            wanted.addAll(Distribution.names(distribution.dependencies(module), "projects"));
        }
        wanted.forEach(distribution::module);
    }

    /** Compiles a class from the source below its package declaration. */
    private static void addClass(Map<String, byte[]> module, String qualifiedName, String source)
            throws IOException {
        int dot = qualifiedName.lastIndexOf('.');
        Path folder = Files.createTempDirectory("assemble-gradle");
        Path file = folder.resolve(qualifiedName.substring(dot + 1) + ".java");
        Files.writeString(file, "package " + qualifiedName.substring(0, dot) + ";\n" + source);
        List<String> arguments =
                List.of("--release", "8", "-Xlint:-options", "-d", "" + folder, "" + file);
        int status =
                ToolProvider.getSystemJavaCompiler()
                        .run(null, null, null, arguments.toArray(String[]::new));
        if (status != 0) {
            throw new IOException("cannot compile " + qualifiedName);
        }
        String path = qualifiedName.replace('.', '/') + ".class";
        module.put(path, Files.readAllBytes(folder.resolve(path)));
        AssembleGradle.delete(folder);
    }
}
