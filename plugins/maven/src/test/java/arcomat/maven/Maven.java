package arcomat.maven;

import static org.assertj.core.api.Assertions.assertThat;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.TimeUnit;
import java.util.stream.Stream;

/** The Maven of this machine, for projects that know nothing of this build but a repository. */
final class Maven {
    /** Maven's own; what was fetched once stays. */
    private static final Path HOME = Path.of("build/maven-repository").toAbsolutePath();

    private static final int SECONDS = 600;

    /** A build is over before the optimising compiler pays. */
    private static final String SHORT_RUN = "-XX:+UseSerialGC -XX:TieredStopAtLevel=1";

    private static final String MODULES =
            """
            <project xmlns="http://maven.apache.org/POM/4.0.0">
              <modelVersion>4.0.0</modelVersion>
              <groupId>shop</groupId>
              <artifactId>all</artifactId>
              <version>1</version>
              <packaging>pom</packaging>
              <modules>
                <module>%s</module>
                <module>%s</module>
              </modules>
            </project>
            """;

    private Maven() {}

    /** What Maven printed. */
    record Outcome(int status, String text) {}

    /** The build of {@code src/test/projects/shop}, with what this build has published. */
    static String pom() throws IOException {
        String repository = Path.of(System.getProperty("repository")).toUri().toString();
        return Files.readString(Path.of("src/test/projects/shop/pom.xml"))
                .replace("@repository@", repository)
                .replace("@version@", System.getProperty("version"));
    }

    /** The same under another name. */
    static String pom(String name) throws IOException {
        return pom().replace("<artifactId>shop<", "<artifactId>" + name + "<");
    }

    /** A build of two modules; the second one may depend on the first. */
    static String modules(String first, String second) {
        return MODULES.formatted(first, second);
    }

    /**
     * Builds a project with a network, to have all that Maven needs; skips where that cannot be.
     */
    static void resolveOnce(Path project) throws IOException, InterruptedException {
        forget(HOME.resolve("arcomat")); // what this build has published by now
        Outcome outcome;
        try {
            outcome = run(project, List.of("verify"));
        } catch (IOException none) {
            assumeTrue(false, "there is no mvn: " + none.getMessage());
            return;
        }
        assumeTrue(
                !outcome.text().contains("Could not transfer artifact"),
                "Maven cannot reach its repository");
        assertThat(outcome.status()).as(outcome.text()).isZero();
    }

    private static void forget(Path folder) throws IOException {
        if (Files.exists(folder)) {
            try (Stream<Path> files = Files.walk(folder)) {
                for (Path each : files.sorted((a, b) -> b.compareTo(a)).toList()) {
                    Files.delete(each);
                }
            }
        }
    }

    /** Builds a project with what is there. */
    static Outcome offline(Path folder, String... arguments)
            throws IOException, InterruptedException {
        List<String> all = new ArrayList<>(List.of("--offline"));
        all.addAll(List.of(arguments));
        return run(folder, all);
    }

    private static Outcome run(Path folder, List<String> arguments)
            throws IOException, InterruptedException {
        List<String> command = new ArrayList<>(List.of("mvn", "--batch-mode", "-ntp"));
        command.add("-Dmaven.repo.local=" + HOME);
        String mirror = System.getenv("MAVEN_MIRROR_URL");
        if (mirror != null) {
            Path settings = folder.resolve("settings.xml");
            Files.writeString(settings, MIRROR.formatted(mirror));
            command.addAll(List.of("--settings", settings.toString()));
        }
        command.addAll(arguments);
        Path log = folder.resolve("log.txt");
        ProcessBuilder maven =
                new ProcessBuilder(command)
                        .directory(folder.toFile())
                        .redirectErrorStream(true)
                        .redirectOutput(log.toFile());
        maven.environment().merge("MAVEN_OPTS", SHORT_RUN, (given, ours) -> ours + " " + given);
        Process process = maven.start();
        boolean ended = process.waitFor(SECONDS, TimeUnit.SECONDS);
        process.destroyForcibly();
        return new Outcome(ended ? process.exitValue() : -1, Files.readString(log));
    }

    private static final String MIRROR =
            """
            <settings>
              <mirrors>
                <mirror>
                  <id>mirror</id>
                  <url>%s</url>
                  <mirrorOf>central</mirrorOf>
                </mirror>
              </mirrors>
            </settings>
            """;
}
