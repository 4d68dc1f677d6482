package arcomat.pipeline.simulate;

import arcomat.model.Trace;
import arcomat.pipeline.PathNames;
import arcomat.pipeline.WrongUse;
import arcomat.pipeline.check.MainComponent;
import arcomat.pipeline.file.AtomicFile;
import arcomat.pipeline.file.Failures;
import arcomat.simulate.test.RecordedSuite;
import arcomat.source.SourceFile;
import arcomat.syntax.Formatter;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.NoSuchFileException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Objects;

/**
 * Keeps a run as a file with a stream test.
 *
 * @param written the file, as the user wrote it
 * @param suite the name of the suite, which is that of its file
 */
record RunRecorder(String written, Path file, String suite) {
    private static final String MARK = "Recorded by arcomat simulate";

    /** Complains before a run is made in vain. */
    static RunRecorder of(String written, PathNames names) throws WrongUse {
        Path file = names.resolve(written);
        String name = file.getFileName().toString();
        if (!name.matches("[\\p{L}_$][\\p{L}\\p{N}_$]*\\.mt")) {
            throw new WrongUse(
                    "'%s' is no file for a suite; --record names a file such as Run.mt", written);
        }
        RunRecorder recorder =
                new RunRecorder(written, file, name.substring(0, name.length() - ".mt".length()));
        try {
            if (!Files.isDirectory(Objects.requireNonNull(file.toAbsolutePath().getParent()))) {
                throw new NoSuchFileException(written);
            }
            recorder.requireRecorded();
        } catch (IOException e) {
            throw Failures.cannot("write", written, e);
        }
        return recorder;
    }

    private void requireRecorded() throws IOException, WrongUse {
        if (Files.exists(file) && !Files.readString(file).contains(MARK)) {
            throw new WrongUse(
                    "'" + written + "' was not recorded; name another file with --record");
        }
    }

    /**
     * @param how the run was made
     * @param decisions that were made in it
     */
    void write(String how, MainComponent main, Trace trace, List<String> decisions)
            throws WrongUse {
        List<String> remarks = new ArrayList<>();
        remarks.add(MARK + ", " + how + ".");
        remarks.addAll(decisions);
        trace.failure().ifPresent(failure -> remarks.add("What has stopped the run, " + failure));
        String text = RecordedSuite.of(suite, trace, main.arguments(), remarks);
        String formatted = Formatter.format(new SourceFile(written, text)).text().orElse(text);
        try {
            requireRecorded();
            AtomicFile.write(file, formatted);
        } catch (IOException e) {
            throw Failures.cannot("write", written, e);
        }
    }
}
