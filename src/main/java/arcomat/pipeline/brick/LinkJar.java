package arcomat.pipeline.brick;

import arcomat.brick.BrickCheck;
import arcomat.brick.BrickReport;
import arcomat.brick.api.BrickTable;
import arcomat.brick.jar.RobotJar.RobotClass;
import arcomat.pipeline.PathNames;
import arcomat.pipeline.Session;
import arcomat.pipeline.Task;
import arcomat.pipeline.WrongUse;
import arcomat.pipeline.file.AtomicFile;
import arcomat.pipeline.file.Failures;
import arcomat.pipeline.file.OutputFolder;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardCopyOption;
import java.util.List;
import java.util.Optional;
import java.util.OptionalInt;
import java.util.regex.Matcher;
import java.util.regex.Pattern;

/**
 * Checks a robot's jar, and lets leJOS' own linker turn it into a program for the brick. It works
 * in a folder of its own, so that nothing half-written stays behind.
 *
 * @param jar path of the jar
 * @param out path of the program for the brick; empty for beside the jar
 * @param nxjHome folder of leJOS NXJ; empty where nobody said
 * @param seconds how long the linker may take
 */
public record LinkJar(String jar, Optional<String> out, Optional<String> nxjHome, int seconds)
        implements Task<LinkJar.Result> {
    private static final int MOST_BYTES = 65_535;
    private static final int MOST_CLASSES = 256;
    private static final int FEW_LINES = 10;

    /** The first line of a stack trace, or what the linker makes of it. */
    private static final Pattern EXCEPTION = Pattern.compile("^(?!\\s).*(Exception|Error)\\b");

    private static final Pattern CLASSES =
            Pattern.compile("Class records\\s*:\\s*([0-9]{1,6})\\b.*");

    /**
     * What came of linking.
     *
     * @param report about the jar; a jar that does not fit is not linked
     * @param linked the program; empty if there is none
     * @param failure why the linker gave none
     * @param output what the linker said, where it failed: all of it, if that is little
     * @param log the file with all of it, as shown, where it is much
     */
    public record Result(
            BrickReport report,
            Optional<Linked> linked,
            Optional<String> failure,
            List<String> output,
            Optional<String> log) {}

    /**
     * A program for the brick.
     *
     * @param path as shown
     * @param bytes size of the file
     * @param classes as the linker counts them; empty if it did not say
     */
    public record Linked(String path, long bytes, OptionalInt classes) {}

    /**
     * @throws WrongUse where there is no such jar or no linker
     */
    @Override
    public Result run(Session session) throws WrongUse {
        JarReader program = JarReader.read(jar, session.names());
        BrickReport report = BrickCheck.check(program.jar(), BrickTable.leJos());
        if (!report.fits()) {
            return result(report, Optional.empty(), Optional.empty());
        }
        session.progress().step("linking " + jar);
        NxjLinker linker = NxjLinker.in(nxjHome, jar, session.names());
        try {
            Path work = Files.createTempDirectory("arcomat-link");
            try {
                unpack(program, work);
                NxjLinker.Run run = linker.run(program.main(), work, seconds);
                return result(run, report, session.names());
            } finally {
                OutputFolder.delete(work);
            }
        } catch (IOException e) {
            throw Failures.cannot("link", jar, e);
        }
    }

    private static Result result(
            BrickReport report, Optional<Linked> linked, Optional<String> failure) {
        return new Result(report, linked, failure, List.of(), Optional.empty());
    }

    private Result result(NxjLinker.Run run, BrickReport report, PathNames names)
            throws IOException {
        Optional<String> failure = run.failure();
        OptionalInt classes = classes(run.output());
        if (classes.orElse(0) > MOST_CLASSES) { // whatever else that has led to
            failure = Optional.of(tooLarge(classes.getAsInt(), "classes", MOST_CLASSES));
        }
        if (failure.isEmpty() && Files.size(run.program()) > MOST_BYTES) {
            int size = (int) Files.size(run.program());
            failure = Optional.of(tooLarge(size, "bytes", MOST_BYTES));
        }
        if (failure.isPresent()) {
            return failed(report, failure, run.output(), names);
        }
        Path file = names.resolve(shown());
        Files.move(run.program(), file, StandardCopyOption.REPLACE_EXISTING);
        Linked linked = new Linked(shown(), Files.size(file), classes);
        return result(report, Optional.of(linked), Optional.empty());
    }

    private String shown() {
        return out.orElse(jar.replaceFirst("(\\.jar)?$", ".nxj"));
    }

    /** The linker lists every class and method before it says what is wrong. */
    private Result failed(
            BrickReport report, Optional<String> failure, List<String> output, PathNames names)
            throws IOException {
        if (output.size() <= FEW_LINES) {
            return new Result(report, Optional.empty(), failure, output, Optional.empty());
        }
        String log = shown().replaceFirst("(\\.nxj)?$", ".nxjlink.log");
        AtomicFile.write(names.resolve(log), String.join("\n", output) + "\n");
        List<String> exception =
                output.stream().filter(line -> EXCEPTION.matcher(line).find()).limit(1).toList();
        return new Result(report, Optional.empty(), failure, exception, Optional.of(log));
    }

    private static String tooLarge(int is, String what, int most) {
        return "the linked program has "
                + is
                + " "
                + what
                + ", and the brick has room for "
                + most
                + "; use fewer components, or spread them over two bricks";
    }

    private static OptionalInt classes(List<String> output) {
        for (String line : output) {
            Matcher matcher = CLASSES.matcher(line);
            if (matcher.matches()) {
                return OptionalInt.of(Integer.parseInt(matcher.group(1)));
            }
        }
        return OptionalInt.empty();
    }

    /** The linker looks for classes in the folder that it is started in. */
    private static void unpack(JarReader jar, Path work) throws IOException {
        for (RobotClass each : jar.classes()) {
            Path file = work.resolve(each.path()).normalize();
            if (!file.startsWith(work)) {
                throw new IOException("entry '" + each.path() + "' leaves the jar");
            }
            Files.createDirectories(file.getParent());
            Files.write(file, each.bytes());
        }
    }
}
