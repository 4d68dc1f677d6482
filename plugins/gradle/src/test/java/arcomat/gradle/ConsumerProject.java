package arcomat.gradle;

import org.gradle.testkit.runner.BuildResult;
import org.gradle.testkit.runner.BuildTask;
import org.gradle.testkit.runner.GradleRunner;

import java.io.File;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.function.UnaryOperator;
import java.util.stream.Collectors;
import java.util.stream.Stream;

/**
 * A user's project, in a folder of its own. It takes plugin, tool and runtime from this build, or
 * from what this build publishes, so that nothing is downloaded, and the Gradle that runs this
 * test.
 */
final class ConsumerProject {
    /** Shared by all tests: the daemon and the tool's process stay warm. */
    private static final Path TEST_KIT = Path.of("build/testkit").toAbsolutePath();

    private static final String TOOL_OF_THIS_BUILD =
            """

            dependencies {
                arcomat files(%s)
                arcomatRuntime files(%s)
            }
            """
                    .formatted(files("tool"), files("runtime"));

    private static final String PUBLISHED =
            """
            pluginManagement {
                repositories {
                    maven { url = '%1$s' }
                }
            }
            dependencyResolutionManagement {
                repositories {
                    maven { url = '%1$s' }
                    def mirror = System.getenv('MAVEN_MIRROR_URL')
                    if (mirror) {
                        maven { url = mirror }
                    }
                    mavenCentral()
                }
            }
            """;

    private final Path folder;
    private final UnaryOperator<GradleRunner> origin;

    private ConsumerProject(Path folder, UnaryOperator<GradleRunner> origin) {
        this.folder = folder;
        this.origin = origin;
    }

    private ConsumerProject(Path folder) {
        this(folder, GradleRunner::withPluginClasspath);
    }

    /** The smallest project with a robot, of {@code src/test/projects/shop}. */
    static ConsumerProject shop(Path folder) {
        ConsumerProject project = copy(Path.of("src/test/projects/shop"), folder);
        project.useToolOfThisBuild();
        return project;
    }

    /**
     * Its models in two projects: {@code robot} has the rover, {@code parts} what that is made of.
     *
     * @param parts appended to the build script of the one
     * @param robot and of the other
     */
    static ConsumerProject shopOfTwo(Path folder, String parts, String robot) {
        ConsumerProject shop = shop(folder);
        String script = shop.read("build.gradle");
        shop.append("settings.gradle", "include 'parts', 'robot'\n");
        shop.write("build.gradle", "");
        shop.write("parts/build.gradle", script.replace("main = 'shop.Rover'", "") + parts);
        shop.write("robot/build.gradle", script + robot);
        copy(shop.path("src/main/arc"), shop.path("parts/src/main/arc"));
        String rover = "src/main/arc/shop/Rover.arc";
        shop.write("robot/" + rover, shop.read(rover));
        shop.delete("parts/" + rover);
        return shop;
    }

    /** A project whose files are yet to be written. */
    static ConsumerProject empty(Path folder) {
        return new ConsumerProject(folder);
    }

    /** Says so in the build script, as it is now. */
    void useToolOfThisBuild() {
        append("build.gradle", TOOL_OF_THIS_BUILD);
    }

    /** Puts the engine for clusters beside the tool. */
    void useEngineOfThisBuild() {
        append("build.gradle", "dependencies { arcomat files(%s) }".formatted(files("engine")));
    }

    /** The shop, with what is published. */
    static ConsumerProject publishedShop(Path folder) {
        ConsumerProject project = published(Path.of("src/test/projects/shop"), folder);
        String plugin = "id 'arcomat'";
        String version = " version '" + System.getProperty("version") + "'";
        project.edit("build.gradle", plugin, plugin + version);
        return project;
    }

    /**
     * A copy of a project, with what is published in the folder {@code repository}; other libraries
     * have been fetched already, for this build.
     */
    static ConsumerProject published(Path original, Path folder) {
        copy(original, folder);
        ConsumerProject project = new ConsumerProject(folder, ConsumerProject::withLibraries);
        String repository = Path.of(System.getProperty("repository")).toUri().toString();
        String settings = project.read("settings.gradle");
        project.write("settings.gradle", PUBLISHED.formatted(repository) + settings);
        return project;
    }

    /** A project as it is, which looks for what is published where Maven puts it on a machine. */
    static ConsumerProject publishedHere(Path folder) {
        return new ConsumerProject(folder, ConsumerProject::withLocalMaven);
    }

    /** Built by another Gradle. */
    ConsumerProject by(Path gradle) {
        return new ConsumerProject(
                folder, runner -> origin.apply(runner).withGradleInstallation(gradle.toFile()));
    }

    private static GradleRunner withLocalMaven(GradleRunner runner) {
        List<String> arguments = new ArrayList<>(runner.getArguments());
        arguments.add("-Dmaven.repo.local=" + System.getProperty("repository"));
        return withLibraries(runner.withArguments(arguments));
    }

    private static GradleRunner withLibraries(GradleRunner runner) {
        List<String> arguments = new ArrayList<>(runner.getArguments());
        arguments.addAll(List.of("--gradle-user-home", System.getProperty("gradle.user.home")));
        return runner.withArguments(arguments);
    }

    /** The coffee service, of {@code models/coffee}, without what was built there. */
    static ConsumerProject coffee(Path folder) {
        Path original = Path.of("../../models/coffee");
        copy(original.resolve("coffee"), folder.resolve("coffee"));
        ConsumerProject project = new ConsumerProject(folder);
        project.write("settings.gradle", "rootProject.name = 'coffee'\n");
        project.write("build.gradle", new ConsumerProject(original).read("build.gradle"));
        project.useToolOfThisBuild();
        return project;
    }

    /** A copy of a folder, as it is. */
    static ConsumerProject copy(Path original, Path folder) {
        try (Stream<Path> files = Files.walk(original)) {
            for (Path file : files.filter(Files::isRegularFile).toList()) {
                Path copy = folder.resolve(original.relativize(file).toString());
                Files.createDirectories(copy.getParent());
                Files.copy(file, copy);
            }
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
        return new ConsumerProject(folder);
    }

    private static String files(String property) {
        return Arrays.stream(System.getProperty(property).split(File.pathSeparator))
                .map(path -> "'" + path.replace('\\', '/') + "'")
                .collect(Collectors.joining(", "));
    }

    Path path(String name) {
        return folder.resolve(name);
    }

    String read(String name) {
        try {
            return Files.readString(path(name));
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
    }

    void write(String name, String text) {
        try {
            Files.createDirectories(path(name).getParent());
            Files.writeString(path(name), text);
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
    }

    void append(String name, String text) {
        write(name, read(name) + text);
    }

    /** Changes a text in a file, which has to be there. */
    void edit(String name, String old, String fresh) {
        String text = read(name);
        if (!text.contains(old)) {
            throw new IllegalArgumentException("there is no '" + old + "' in " + name);
        }
        write(name, text.replace(old, fresh));
    }

    void delete(String name) {
        try {
            Files.delete(path(name));
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
    }

    /** A build that has to succeed. */
    BuildResult build(String... arguments) {
        return runner(arguments).build();
    }

    /** A build that has to fail. */
    BuildResult fail(String... arguments) {
        return runner(arguments).buildAndFail();
    }

    /** What became of the tasks of a build, such as {@code :checkArc UP_TO_DATE}. */
    static List<String> outcomes(BuildResult result) {
        return result.getTasks().stream().map(ConsumerProject::outcome).toList();
    }

    private static String outcome(BuildTask task) {
        return task.getPath() + " " + task.getOutcome();
    }

    private GradleRunner runner(String... arguments) {
        List<String> all = new ArrayList<>(List.of("--offline", "--console=plain"));
        all.addAll(List.of(arguments));
        return origin.apply(
                GradleRunner.create()
                        .withGradleInstallation(new File(System.getProperty("gradle.home")))
                        .withTestKitDir(TEST_KIT.toFile())
                        .withProjectDir(folder.toFile())
                        .withArguments(all));
    }
}
