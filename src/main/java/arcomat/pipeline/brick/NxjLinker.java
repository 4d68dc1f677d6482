package arcomat.pipeline.brick;

import arcomat.pipeline.LimitedProcess;
import arcomat.pipeline.PathNames;
import arcomat.pipeline.WrongUse;

import java.io.IOException;
import java.nio.charset.Charset;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalInt;

/** {@code nxjlink} of an installation of leJOS NXJ, as a process with a time limit. */
final class NxjLinker {
    /**
     * What every Java is started with; the linker notices its overflows only with assertions on.
     */
    private static final String JAVA_OPTIONS = "JAVA_TOOL_OPTIONS";

    private static final String ASSERTIONS = "-ea";
    private static final String NOTE_OF_JAVA = "Picked up " + JAVA_OPTIONS;

    private final Path home;
    private final Path command;

    private NxjLinker(Path home, Path command) {
        this.home = home;
        this.command = command;
    }

    /**
     * @param home folder of leJOS NXJ
     * @param jar for the hint how to get there
     */
    static NxjLinker in(Optional<String> home, String jar, PathNames names) throws WrongUse {
        if (home.isEmpty()) {
            throw new WrongUse(
                    "linking needs leJOS NXJ 0.9.1: install it, set NXJ_HOME to its folder, and run"
                            + " 'arcomat link --jar %s' again",
                    jar);
        }
        Path folder = names.resolve(home.get());
        for (String name : List.of("nxjlink", "nxjlink.bat")) {
            Path command = folder.resolve("bin").resolve(name);
            boolean batch = name.endsWith(".bat");
            if (Files.isExecutable(command) && batch == isWindows()) {
                return new NxjLinker(folder, command);
            }
        }
        throw new WrongUse(
                "'%s' is not a folder of leJOS NXJ: it has no program bin/nxjlink; set NXJ_HOME to"
                        + " one that has",
                home.get());
    }

    private static boolean isWindows() {
        return System.getProperty("os.name").startsWith("Windows");
    }

    /**
     * A run of the linker.
     *
     * @param program the file that it should have written
     * @param failure empty if it wrote one
     */
    record Run(Path program, Optional<String> failure, List<String> output) {}

    /**
     * Links the classes in a folder.
     *
     * @param main qualified name of the main class
     */
    Run run(String main, Path work, int seconds) throws IOException {
        Path program = work.resolve("program.nxj");
        Path log = work.resolve("nxjlink.log");
        ProcessBuilder builder =
                new ProcessBuilder(
                        command.toString(), "--verbose", "--output", program.toString(), main);
        builder.directory(work.toFile());
        builder.redirectErrorStream(true);
        builder.redirectOutput(log.toFile());
        builder.redirectInput(ProcessBuilder.Redirect.from(nothing(work).toFile()));
        Map<String, String> environment = builder.environment();
        environment.put("NXJ_HOME", home.toString());
        environment.merge(JAVA_OPTIONS, ASSERTIONS, (given, added) -> given + " " + added);
        Optional<String> failure = failure(builder, seconds, program);
        return new Run(program, failure, output(log));
    }

    private static Path nothing(Path work) throws IOException {
        return Files.createFile(work.resolve("nothing.txt"));
    }

    private static Optional<String> failure(ProcessBuilder builder, int seconds, Path program)
            throws IOException {
        try {
            OptionalInt status = LimitedProcess.run(builder, seconds);
            if (status.isEmpty()) {
                return Optional.of(
                        "nxjlink has not ended after "
                                + seconds
                                + " seconds and was stopped; allow it more with --limit");
            }
            if (status.getAsInt() != 0) {
                return Optional.of("nxjlink failed with exit status " + status.getAsInt());
            }
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
            return Optional.of("nxjlink was interrupted");
        }
        return Files.exists(program) && Files.size(program) > 0
                ? Optional.empty()
                : Optional.of("nxjlink ended without an error, but wrote no program");
    }

    private static List<String> output(Path log) throws IOException {
        String text = new String(Files.readAllBytes(log), Charset.defaultCharset());
        return text.lines().filter(line -> !line.startsWith(NOTE_OF_JAVA)).toList();
    }
}
