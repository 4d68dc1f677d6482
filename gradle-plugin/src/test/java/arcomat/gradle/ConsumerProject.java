package arcomat.gradle;

import org.gradle.testkit.runner.BuildResult;
import org.gradle.testkit.runner.GradleRunner;

import java.io.File;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.stream.Collectors;

/**
 * A user's project with one robot, in a folder of its own. It takes plugin, tool and runtime from
 * this build, so that nothing is downloaded, and the Gradle that runs this test.
 */
final class ConsumerProject {
    /** Shared by all tests of a run: the daemon, and the tool's process, stay warm. */
    private static final Path TEST_KIT = Path.of("build/testkit").toAbsolutePath();

    static final String BUMPER = "src/main/arc/shop/Bumper.arc";

    private final Path folder;

    private ConsumerProject(Path folder) {
        this.folder = folder;
    }

    /** A project in an empty folder, with a robot that stops at walls, and its test. */
    static ConsumerProject in(Path folder) {
        ConsumerProject project = new ConsumerProject(folder);
        project.write("settings.gradle", "rootProject.name = 'shop'\n");
        project.write("build.gradle", script(""));
        project.write(
                BUMPER,
                """
                package shop;

                import shop.Shop.*;

                /** Stops at walls. */
                component Bumper {
                    port in Boolean wall, out Command wheels;

                    automaton {
                        state driving, standing;

                        initial driving / {wheels = go};

                        driving -> standing {wall == true} / {wheels = halt};
                        standing -> driving {wall == false} / {wheels = go};
                    }
                }
                """);
        project.write(
                "src/main/arc/shop/Shop.cd",
                """
                package shop;

                classdiagram Shop {
                    enum Command { go, halt; }
                }
                """);
        project.write(
                "src/test/arc/shop/BumperTest.mt",
                """
                package shop;

                testsuite BumperTest for shop.Bumper {
                    test stops {
                        input {
                            wall: <true, 2*Tk>;
                        }
                        expect {
                            wheels: <go, Tk, halt, Tk>;
                        }
                    }
                }
                """);
        return project;
    }

    /** A build script with the plugin and more lines. */
    static String script(String lines) {
        return """
        plugins {
            id 'arcomat'
        }

        dependencies {
            arcomat files(%s)
        }

        """
                        .formatted(files("tool"))
                + lines;
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

    /** Changes a text in a file, which has to be there. */
    void edit(String name, String old, String fresh) {
        String text = read(name);
        if (!text.contains(old)) {
            throw new IllegalArgumentException("there is no '" + old + "' in " + name);
        }
        write(name, text.replace(old, fresh));
    }

    /** A build that has to succeed. */
    BuildResult build(String... arguments) {
        return runner(arguments).build();
    }

    /** A build that has to fail. */
    BuildResult fail(String... arguments) {
        return runner(arguments).buildAndFail();
    }

    private GradleRunner runner(String... arguments) {
        List<String> all = new ArrayList<>(List.of("--offline", "--console=plain"));
        all.addAll(List.of(arguments));
        return GradleRunner.create()
                .withGradleInstallation(new File(System.getProperty("gradle.home")))
                .withTestKitDir(TEST_KIT.toFile())
                .withPluginClasspath()
                .withProjectDir(folder.toFile())
                .withArguments(all);
    }
}
