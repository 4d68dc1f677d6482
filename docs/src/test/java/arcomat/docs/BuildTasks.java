package arcomat.docs;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.regex.Matcher;
import java.util.regex.Pattern;

/** The tasks of this project's build, as its scripts and the Gradle plugin name them. */
record BuildTasks(String scripts) {
    private static final Pattern TASK = Pattern.compile("(?<= )(?::[\\w-]+:)?[a-z]\\w+(?= |$)");

    /** Tasks that Gradle has by itself. */
    private static final String BUILT_IN =
            "'build' 'check' 'installDist' 'publishToMavenLocal' 'slowTest' 'browserTest' 'test'";

    static BuildTasks read() throws IOException {
        StringBuilder scripts = new StringBuilder(BUILT_IN);
        for (String script :
                List.of(
                        "build.gradle",
                        "gradle/changes.gradle",
                        "gradle/checksums.gradle",
                        "gradle/compiler.gradle",
                        "gradle/mutation.gradle",
                        "gradle/sbom.gradle",
                        "gradle/vscode.gradle",
                        "gradle/tests.gradle",
                        "cli/build.gradle",
                        "verify/build.gradle",
                        "benchmarks/build.gradle",
                        "site/build.gradle")) {
            scripts.append(Files.readString(Path.of(script)));
        }
        Path plugin = Path.of("plugins/gradle/src/main/java/arcomat/gradle");
        try (var files = Files.list(plugin)) {
            for (Path file : files.sorted().toList()) {
                scripts.append(Files.readString(file));
            }
        }
        return new BuildTasks(scripts.toString());
    }

    /** All tasks of a line such as {@code ./gradlew build formatArc}, up to two spaces. */
    void find(String line) {
        String command = line.substring(line.indexOf("./gradlew")).replaceAll(" {2}.*", "");
        Matcher task = TASK.matcher(command);
        while (task.find()) {
            String name = task.group().replaceAll(".*:", "");
            assertThat(scripts)
                    .as(line)
                    .containsPattern("['\"]" + name + "['\"]|\n" + name + " \\{");
        }
    }
}
