package arcomat.benchmarks.build;

import arcomat.benchmarks.measure.Measurement;

import org.gradle.testkit.runner.GradleRunner;
import org.gradle.testkit.runner.TaskOutcome;

import java.io.File;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import java.util.stream.Collectors;
import java.util.stream.Stream;

/**
 * Runs builds in turn, so that a machine that does other work at times does it to all of them. The
 * project is the coffee service with a class in Java: without the plugin the class is compiled,
 * with it the models are checked, too; nothing has changed, so there is nothing to do.
 */
final class WarmBuilds {
    static final String WITH = "with checkArc";
    static final String WITHOUT = "without";
    static final String CACHED = ", configuration cache";

    private static final int WARM_UP = 15;
    private static final int MEASURED = 20;
    private static final String CHECK = ":checkArc";

    private static final String WITH_PLUGIN =
            """
            plugins {
                id 'arcomat'
            }

            sourceSets.main.arc.srcDirs = ['.']
            arcomat.targets = []
            dependencies {
                arcomat files(%s)
            }
            """;
    private static final String WITHOUT_PLUGIN =
            """
            plugins {
                id 'java'
            }
            """;

    private final Path folder;
    private final Map<String, GradleRunner> builds = new LinkedHashMap<>();

    private WarmBuilds(Path folder) {
        this.folder = folder;
    }

    /** Milliseconds of each kind of build. */
    static Map<String, Measurement> measure() throws IOException {
        WarmBuilds builds = new WarmBuilds(Files.createTempDirectory("warm-builds"));
        String tool =
                files("tool").stream()
                        .map(file -> "'" + file + "'")
                        .collect(Collectors.joining(", "));
        builds.add(WITHOUT, WITHOUT_PLUGIN, "classes");
        builds.add(WITH, WITH_PLUGIN.formatted(tool), "classes", "checkArc");
        return builds.run();
    }

    private static List<File> files(String property) {
        return Arrays.stream(System.getProperty(property).split(File.pathSeparator))
                .map(File::new)
                .toList();
    }

    /** A project, and how it is built without the configuration cache and with it. */
    private void add(String name, String script, String... tasks) throws IOException {
        Path project = Files.createDirectory(folder.resolve("p" + builds.size()));
        copy(Path.of("models/coffee/coffee"), project.resolve("coffee"));
        Files.writeString(project.resolve("settings.gradle"), "rootProject.name = 'coffee'\n");
        Files.writeString(project.resolve("build.gradle"), script);
        Path java = Files.createDirectories(project.resolve("src/main/java"));
        Files.writeString(java.resolve("Small.java"), "class Small {}\n");
        builds.put(name, runner(project, tasks, "--no-configuration-cache"));
        builds.put(name + CACHED, runner(project, tasks, "--configuration-cache"));
    }

    private GradleRunner runner(Path project, String[] tasks, String... options) {
        List<String> arguments = new ArrayList<>(List.of(tasks));
        arguments.addAll(List.of(options));
        arguments.add("--offline");
        return GradleRunner.create()
                .withGradleInstallation(new File(System.getProperty("gradle.home")))
                .withTestKitDir(folder.resolve("home").toFile())
                .withPluginClasspath(files("plugin"))
                .withProjectDir(project.toFile())
                .withArguments(arguments);
    }

    private Map<String, Measurement> run() {
        Map<String, List<Double>> times = new LinkedHashMap<>();
        for (int round = 0; round < WARM_UP + MEASURED; round++) {
            for (Map.Entry<String, GradleRunner> build : builds.entrySet()) {
                double milliseconds = time(build.getValue(), round > 0);
                if (round >= WARM_UP) {
                    times.computeIfAbsent(build.getKey(), name -> new ArrayList<>())
                            .add(milliseconds);
                }
            }
        }
        Map<String, Measurement> measurements = new TreeMap<>();
        times.forEach(
                (name, values) -> measurements.put(name, Measurement.of(name, values, "ms/build")));
        return measurements;
    }

    private static double time(GradleRunner runner, boolean upToDate) {
        long start = System.nanoTime();
        var result = runner.build();
        double milliseconds = (System.nanoTime() - start) / 1e6;
        var check = result.task(CHECK);
        if (upToDate && check != null && check.getOutcome() != TaskOutcome.UP_TO_DATE) {
            throw new IllegalStateException("not up to date:\n" + result.getOutput());
        }
        return milliseconds;
    }

    private static void copy(Path from, Path to) throws IOException {
        try (Stream<Path> files = Files.walk(from)) {
            for (Path file : files.filter(Files::isRegularFile).toList()) {
                Path copy = to.resolve(from.relativize(file).toString());
                Files.createDirectories(copy.getParent());
                Files.copy(file, copy);
            }
        }
    }
}
