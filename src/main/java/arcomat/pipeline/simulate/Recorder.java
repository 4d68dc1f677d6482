package arcomat.pipeline.simulate;

import arcomat.model.Trace;
import arcomat.pipeline.check.MainComponent;
import arcomat.pipeline.file.AtomicFile;
import arcomat.pipeline.file.Failures;
import arcomat.pipeline.step.PathNames;
import arcomat.pipeline.step.WrongUse;
import arcomat.simulate.test.RecordedSuite;
import arcomat.source.SourceFile;
import arcomat.syntax.Formatter;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.NoSuchFileException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;

/** Keeps a run as a file with a stream test. */
final class Recorder {
    private static final String MARK = "Recorded by arcomat simulate";

    private Recorder() {}

    /** Complains before a run is made in vain. */
    static void requireWritable(SimulationRequest request, PathNames names) throws WrongUse {
        String written = request.record().orElseThrow();
        Path file = names.resolve(written);
        suite(written, file);
        try {
            if (!Files.isDirectory(file.toAbsolutePath().getParent())) {
                throw new NoSuchFileException(written);
            }
            requireRecorded(written, file);
        } catch (IOException e) {
            throw unwritable(written, e);
        }
    }

    private static void requireRecorded(String written, Path file) throws IOException, WrongUse {
        if (Files.exists(file) && !Files.readString(file).contains(MARK)) {
            throw new WrongUse(
                    "'" + written + "' was not recorded; name another file with --record");
        }
    }

    private static WrongUse unwritable(String written, IOException e) {
        return new WrongUse("cannot write '" + written + "': " + Failures.reason(e));
    }

    static void write(
            SimulationRequest request,
            MainComponent main,
            Trace trace,
            List<String> decisions,
            PathNames names)
            throws WrongUse {
        String written = request.record().orElseThrow();
        Path file = names.resolve(written);
        String suite = suite(written, file);
        List<String> remarks = new ArrayList<>();
        remarks.add(
                MARK
                        + ", choices "
                        + request.choosing().name().toLowerCase(Locale.ROOT)
                        + ", seed "
                        + request.seed()
                        + ".");
        remarks.addAll(decisions);
        trace.failure().ifPresent(failure -> remarks.add("What has stopped the run, " + failure));
        String text = RecordedSuite.of(suite, trace, main.arguments(), remarks);
        String formatted = Formatter.format(new SourceFile(written, text)).text().orElse(text);
        try {
            requireRecorded(written, file);
            AtomicFile.write(file, formatted);
        } catch (IOException e) {
            throw unwritable(written, e);
        }
    }

    /** The name of the suite is the name of its file. */
    private static String suite(String written, Path file) throws WrongUse {
        String name = file.getFileName().toString();
        if (!name.matches("[\\p{L}_$][\\p{L}\\p{N}_$]*\\.mt")) {
            throw new WrongUse(
                    "'"
                            + written
                            + "' is no file for a suite; --record names a file such as Run.mt");
        }
        return name.substring(0, name.length() - ".mt".length());
    }
}
