package arcomat.release;

import static org.assertj.core.api.Assertions.assertThat;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

import java.io.File;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.stream.Stream;

/**
 * A rehearsal of a release: what {@code distributions} offers is unpacked in an empty folder, and
 * has to do there what the README promises, without the repository.
 */
@Tag("distribution")
class ReleaseTest {
    private static final Path OFFERED = Path.of("build/distributions").toAbsolutePath();

    /** A class that every check loads, from wherever. */
    private static final String LOADED = "arcomat.check.Checks source: ";

    private static final String MAPPED = LOADED + "shared objects file";

    @TempDir private Path folder;

    private record Outcome(int status, String output) {}

    private Path arcomat;

    @BeforeEach
    void unpack() throws Exception {
        assertThat(run("unzip", "-q", offered(".zip").toString()).status()).isZero();
        arcomat = only(folder, "arcomat-").resolve("bin/arcomat");
    }

    private static Path offered(String end) throws IOException {
        try (Stream<Path> files = Files.list(OFFERED)) {
            return files.filter(file -> file.toString().endsWith(end)).findFirst().orElseThrow();
        }
    }

    private static Path only(Path folder, String start) throws IOException {
        try (Stream<Path> files = Files.list(folder)) {
            return files.filter(file -> file.getFileName().toString().startsWith(start))
                    .findFirst()
                    .orElseThrow();
        }
    }

    private Outcome run(String... command) throws Exception {
        return run(Map.of(), command);
    }

    private Outcome run(Map<String, String> environment, String... command) throws Exception {
        ProcessBuilder builder =
                new ProcessBuilder(command).directory(folder.toFile()).redirectErrorStream(true);
        builder.environment().putAll(environment);
        Process process = builder.start();
        String output = new String(process.getInputStream().readAllBytes());
        return new Outcome(process.waitFor(), output);
    }

    private String[] command(String... arguments) {
        List<String> command = new ArrayList<>(List.of(arcomat.toString()));
        command.addAll(List.of(arguments));
        return command.toArray(String[]::new);
    }

    private List<String> loaded(Map<String, String> environment) throws Exception {
        Path log = folder.resolve("loaded.txt");
        Map<String, String> all = new HashMap<>(environment);
        all.put("JAVA_OPTS", "-Xlog:class+load:file=" + log);
        assertThat(run(all, command("check", models())).status()).isZero();
        return Files.readAllLines(log).stream().filter(line -> line.contains(LOADED)).toList();
    }

    private void moveTo(String name) throws IOException {
        Path moved = folder.resolve(name);
        Files.move(arcomat.getParent().getParent(), moved);
        arcomat = moved.resolve("bin/arcomat");
    }

    private String models() {
        return arcomat.getParent().resolveSibling("models/coffee").toString();
    }

    private String[] forTheBrick() {
        String fetcher = "coffee.fetcher.Fetcher";
        return new String[] {
            "generate", "--target", "lejos", "--out", "brick", "--main", fetcher, models()
        };
    }

    @Test
    void goesOnTheTourOfTheReadme() throws Exception {
        String[][] tour = {
            {"check", models()},
            {"test", models()},
            {"generate", "--target", "jvm", "--out", "jvm", models()},
            {
                "simulate",
                "--engine",
                "compiled",
                "--input",
                models() + "/coffee/fetcher/FetcherTest.mt#makesRoomAndReturnsToTheLine",
                models()
            },
            forTheBrick(),
            {
                "run-brick",
                "--jar",
                "brick/Fetcher.jar",
                "--script",
                models() + "/scripts/fetcher.script"
            }
        };
        for (String[] each : tour) {
            Outcome outcome = run(command(each));
            assertThat(outcome.status()).as(outcome.output()).isZero();
        }
    }

    @Test
    void theFirstStartInAPlaceMakesTheArchiveOfItsClasses() throws Exception {
        assertThat(run(command("--version")).output()).matches("arcomat \\d.*\n");
        assertThat(loaded(Map.of())).singleElement().asString().contains(MAPPED);
        moveTo("moved");
        run(command("--version"));
        assertThat(loaded(Map.of())).singleElement().asString().contains(MAPPED);
        // Java maps nothing from a place with a blank in its name, and it has to run all the same.
        moveTo("moved again");
        assertThat(run(command("--version")).output()).matches("arcomat \\d.*\n");
    }

    @Test
    void theArchiveMayLieElsewhereOrNowhere() throws Exception {
        String elsewhere = folder.resolve("cache/of arcomat.jsa").toString();
        Map<String, String> there = Map.of("ARCOMAT_ARCHIVE", elsewhere);
        run(there, command("--version"));
        assertThat(loaded(there)).singleElement().asString().contains(MAPPED);
        Map<String, String> nowhere = Map.of("ARCOMAT_ARCHIVE", "none");
        assertThat(loaded(nowhere)).singleElement().asString().doesNotContain(MAPPED);
        assertThat(arcomat.getParent().resolveSibling("lib/arcomat.jsa")).doesNotExist();
        assertThat(folder.resolve("none.for")).doesNotExist();
    }

    @Test
    void runsWithAJavaOfItsOwn() throws Exception {
        String image = offered("-" + System.getProperty("os.arch") + ".tar.gz").toString();
        Path own = Files.createDirectory(folder.resolve("own"));
        assertThat(run("tar", "xzf", image, "-C", own.toString()).status()).isZero();
        arcomat = only(own, "arcomat-").resolve("bin/arcomat");
        Map<String, String> noJava = Map.of("JAVA_HOME", "/nowhere");
        Outcome outcome = run(noJava, command(forTheBrick()));
        assertThat(outcome.status()).as(outcome.output()).isZero();
        assertThat(folder.resolve("brick/Fetcher.jar")).isNotEmptyFile();
    }

    @Test
    void isAPackageForDebianIfDpkgIsThere() throws Exception {
        assumeTrue(isThere("dpkg-deb"), "dpkg-deb");
        String deb = offered("_all.deb").toString();
        assertThat(run("dpkg-deb", "--field", deb, "Package", "Description").output())
                .startsWith("Package: arcomat\nDescription: Checks");
        assertThat(run("dpkg-deb", "--extract", deb, "root").status()).isZero();
        Path root = folder.resolve("root/usr");
        assertThat(root.resolve("bin/arcomat")).isExecutable();
        assertThat(root.resolve("share/man/man1/arcomat-check.1")).isNotEmptyFile();
        assertThat(root.resolve("share/bash-completion/completions/arcomat")).isNotEmptyFile();
        arcomat = root.resolve("share/arcomat/bin/arcomat");
        assertThat(run(command("check", models())).status()).isZero();
    }

    @Test
    void checksumsAndAddressesAreThoseOfTheZip() throws Exception {
        Path zip = offered(".zip");
        Outcome sums =
                run("sh", "-c", "cd \"$0\" && sha256sum --check SHA256SUMS", OFFERED.toString());
        assertThat(sums.status()).as(sums.output()).isZero();
        String sum = run("sha256sum", zip.toString()).output().split(" ")[0];
        for (String each : List.of("arcomat.rb", "sdkman.json", "action.yml")) {
            assertThat(OFFERED.resolve(each))
                    .content()
                    .contains(sum)
                    .contains("/" + zip.getFileName())
                    .doesNotContainPattern("@\\w+@");
        }
    }

    @Test
    void isAContainerIfABuilderIsThereAndCanFetchWhatItStandsOn() throws Exception {
        String builder = isThere("podman") ? "podman" : "docker";
        assumeTrue(isThere(builder) && run(builder, "info").status() == 0, "podman or docker");
        String base = Files.readString(OFFERED.resolve("Containerfile"));
        base = base.substring(base.indexOf("\nFROM ") + 6).lines().findFirst().orElseThrow();
        assumeTrue(run(builder, "pull", base).status() == 0, base);
        String file = OFFERED.resolve("Containerfile").toString();
        String name = "arcomat-rehearsal";
        Outcome built = run(builder, "build", "-t", name, "-f", file, OFFERED.toString());
        assertThat(built.status()).as(built.output()).isZero();
        Outcome version = run(builder, "run", "--rm", name, "--version");
        assertThat(version.output()).startsWith("arcomat ");
    }

    private static boolean isThere(String program) {
        return Stream.of(System.getenv("PATH").split(File.pathSeparator))
                .anyMatch(each -> Files.isExecutable(Path.of(each, program)));
    }
}
