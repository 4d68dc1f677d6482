package arcomat.pipeline.analysis;

import arcomat.pipeline.LimitedProcess;
import arcomat.pipeline.PathNames;
import arcomat.pipeline.WrongUse;
import arcomat.pipeline.file.Failures;

import java.io.File;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.OptionalInt;

/** The program MONA, as a process with limits of time and memory. */
final class MonaProgram {
    private static final int MEGABYTES = 2048;

    /** Debian's MONA 1.4-18 has a buffer that long formulas overflow, most from 320,000 on. */
    private static final int MANY_CHARACTERS = 200_000;

    /** The exit status that a shell reports for a program that has aborted. */
    private static final int ABORTED = 134;

    private static final int MOST_OUTPUT = 1 << 22;
    private static final int MOST_WORDS = 200;

    private final Path program;

    private MonaProgram(Path program) {
        this.program = program;
    }

    /**
     * @param name a name, which is looked for where programs are, or a path
     * @throws WrongUse where there is no such program
     */
    static MonaProgram find(String name, PathNames names) throws WrongUse {
        List<Path> places = new ArrayList<>();
        if (name.contains("/") || name.contains(File.separator)) {
            places.add(names.resolve(name));
        } else {
            String path = Optional.ofNullable(System.getenv("PATH")).orElse("");
            for (String folder : path.split(File.pathSeparator)) {
                places.add(names.resolve(folder).resolve(name));
            }
        }
        for (Path place : places) {
            if (Files.isRegularFile(place) && Files.isExecutable(place)) {
                return new MonaProgram(place);
            }
        }
        throw new WrongUse(
                "there is no program '%s': install MONA (Debian's package 'mona'), name it with"
                        + " --mona, or leave '--engine mona' out",
                name);
    }

    /**
     * Decides a formula.
     *
     * @param seconds after which the program is ended
     * @throws WrongUse where it cannot be started
     */
    MonaAnswer decide(String formula, int seconds) throws WrongUse {
        try {
            Path work = Files.createTempDirectory("arcomat-mona");
            try {
                return decide(formula, seconds, work);
            } finally {
                for (String file : List.of("formula.mona", "answer.txt", "nothing.txt")) {
                    Files.deleteIfExists(work.resolve(file));
                }
                Files.delete(work);
            }
        } catch (IOException e) {
            throw Failures.cannot("run", program.toString(), e);
        }
    }

    private MonaAnswer decide(String formula, int seconds, Path work) throws IOException {
        Path text = Files.writeString(work.resolve("formula.mona"), formula);
        Path answer = work.resolve("answer.txt");
        ProcessBuilder builder = new ProcessBuilder(command(text));
        builder.redirectErrorStream(true);
        builder.redirectOutput(answer.toFile());
        builder.redirectInput(Files.createFile(work.resolve("nothing.txt")).toFile());
        try {
            OptionalInt status = LimitedProcess.run(builder, seconds);
            return status.isEmpty()
                    ? new MonaAnswer.None(
                            "MONA has not answered after "
                                    + (seconds == 1 ? "1 second" : seconds + " seconds")
                                    + " and was stopped; allow it more with --timeout")
                    : answer(status.getAsInt(), output(answer), formula.length());
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
            return new MonaAnswer.None("MONA was interrupted");
        }
    }

    /** Only a shell can limit memory, and files, and there is none on Windows. */
    private List<String> command(Path text) {
        List<String> command = new ArrayList<>();
        if (!System.getProperty("os.name").startsWith("Windows")) {
            String limits =
                    "ulimit -v " + MEGABYTES * 1024 + "; ulimit -f 65536; exec \"$0\" \"$@\"";
            command.addAll(List.of("sh", "-c", limits));
        }
        command.addAll(List.of(program.toString(), "-q", text.toString()));
        return command;
    }

    private static String output(Path file) throws IOException {
        try (var stream = Files.newInputStream(file)) {
            return new String(stream.readNBytes(MOST_OUTPUT), StandardCharsets.UTF_8);
        }
    }

    private static MonaAnswer answer(int status, String output, int characters) {
        if (output.contains("out of memory")) {
            return new MonaAnswer.None(
                    "MONA ran out of memory, of which it gets " + MEGABYTES + " MB");
        }
        if (status == ABORTED && characters > MANY_CHARACTERS) {
            return new MonaAnswer.None(
                    "MONA aborted on a formula of %s characters; MONA 1.4-18 does so on long ones"
                            .formatted(characters));
        }
        if (status != 0) {
            String said = firstWords(output);
            return new MonaAnswer.None(
                    "MONA failed with exit status " + status + (said.isEmpty() ? "" : ": " + said));
        }
        return MonaAnswer.read(output);
    }

    private static String firstWords(String output) {
        return output.lines()
                .map(String::strip)
                .filter(line -> !line.isEmpty())
                .findFirst()
                .map(line -> line.length() > MOST_WORDS ? line.substring(0, MOST_WORDS) : line)
                .orElse("");
    }
}
