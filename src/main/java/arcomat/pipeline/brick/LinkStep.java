package arcomat.pipeline.brick;

import arcomat.brick.BrickCheck;
import arcomat.brick.BrickReport;
import arcomat.brick.api.BrickTable;
import arcomat.brick.jar.RobotJar.RobotClass;
import arcomat.pipeline.file.AtomicFile;
import arcomat.pipeline.file.Failures;
import arcomat.pipeline.step.PathNames;
import arcomat.pipeline.step.Progress;
import arcomat.pipeline.step.WrongUse;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardCopyOption;
import java.util.Comparator;
import java.util.List;
import java.util.Optional;
import java.util.OptionalInt;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Stream;

/**
 * Lets leJOS' own linker turn a jar into a program for the brick. It works in a folder of its own,
 * so that nothing half-written stays behind.
 */
public final class LinkStep {
    private static final int MOST_BYTES = 65_535;
    private static final int MOST_CLASSES = 256;
    private static final int FEW_LINES = 10;

    /** The first line of a stack trace, or what the linker makes of it. */
    private static final Pattern EXCEPTION = Pattern.compile("^(?!\\s).*(Exception|Error)\\b");

    private static final Pattern CLASSES =
            Pattern.compile("Class records\\s*:\\s*([0-9]{1,6})\\b.*");

    private final JarReader jar;
    private final LinkRequest request;
    private final PathNames names;

    private LinkStep(JarReader jar, LinkRequest request, PathNames names) {
        this.jar = jar;
        this.request = request;
        this.names = names;
    }

    public static LinkResult run(LinkRequest request, PathNames names, Progress progress)
            throws WrongUse {
        JarReader jar = JarReader.read(request.jar(), names);
        BrickReport report = BrickCheck.check(jar.jar(), BrickTable.leJos());
        if (!report.fits()) {
            return LinkResult.refused(report);
        }
        progress.step("linking " + request.jar());
        return new LinkStep(jar, request, names).link(report);
    }

    private LinkResult link(BrickReport report) throws WrongUse {
        NxjLinker linker = NxjLinker.in(request.nxjHome(), request.jar(), names);
        try {
            Path work = Files.createTempDirectory("arcomat-link");
            try {
                unpack(work);
                return result(linker.run(jar.main(), work, request.seconds()), report);
            } finally {
                delete(work);
            }
        } catch (IOException e) {
            throw new WrongUse("cannot link '" + jar.shown() + "': " + Failures.reason(e));
        }
    }

    private LinkResult result(NxjLinker.Run run, BrickReport report) throws IOException {
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
            return failed(report, failure.get(), run.output());
        }
        String shown = out();
        Path out = names.resolve(shown);
        Files.move(run.program(), out, StandardCopyOption.REPLACE_EXISTING);
        LinkResult.Linked linked = new LinkResult.Linked(shown, Files.size(out), classes);
        return LinkResult.of(report, linked);
    }

    private String out() {
        return request.out().orElse(request.jar().replaceFirst("(\\.jar)?$", ".nxj"));
    }

    /** The linker lists every class and method before it says what is wrong. */
    private LinkResult failed(BrickReport report, String failure, List<String> output)
            throws IOException {
        if (output.size() <= FEW_LINES) {
            return LinkResult.failed(report, failure, output, Optional.empty());
        }
        String log = out().replaceFirst("(\\.nxj)?$", ".nxjlink.log");
        AtomicFile.write(names.resolve(log), String.join("\n", output) + "\n");
        List<String> exception =
                output.stream().filter(line -> EXCEPTION.matcher(line).find()).limit(1).toList();
        return LinkResult.failed(report, failure, exception, Optional.of(log));
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
    private void unpack(Path work) throws IOException {
        for (RobotClass each : jar.classes()) {
            Path file = work.resolve(each.path()).normalize();
            if (!file.startsWith(work)) {
                throw new IOException("entry '" + each.path() + "' leaves the jar");
            }
            Files.createDirectories(file.getParent());
            Files.write(file, each.bytes());
        }
    }

    private static void delete(Path folder) throws IOException {
        try (Stream<Path> paths = Files.walk(folder)) {
            for (Path path : paths.sorted(Comparator.reverseOrder()).toList()) {
                Files.delete(path);
            }
        }
    }
}
