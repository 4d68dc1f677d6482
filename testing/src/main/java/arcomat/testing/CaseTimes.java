package arcomat.testing;

import org.junit.platform.engine.TestExecutionResult;
import org.junit.platform.launcher.TestExecutionListener;
import org.junit.platform.launcher.TestIdentifier;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardOpenOption;
import java.util.LinkedHashMap;
import java.util.Locale;
import java.util.Map;

/**
 * Writes down the processor time of each test case, in seconds, with that of the programs that the
 * case has started and awaited. The system property {@code case.times} names the folder; every test
 * process writes a file of its own there, a line for each case: seconds, a tab, the case. Of a case
 * that takes more than two seconds, they are those of a quiet machine, as {@link MachineSpeed}
 * estimates them.
 */
public final class CaseTimes implements TestExecutionListener {
    /** What takes more is measured by what the machine does in that time now. */
    private static final double LONGEST = 2;

    private final Map<String, Double> begun = new LinkedHashMap<>();

    @Override
    public void executionStarted(TestIdentifier test) {
        if (test.isTest()) {
            begun.put(test.getUniqueId(), ProcessorTime.seconds());
        }
    }

    @Override
    public void executionFinished(TestIdentifier test, TestExecutionResult result) {
        Double start = begun.remove(test.getUniqueId());
        if (start != null) {
            double seconds = ProcessorTime.seconds() - start;
            if (seconds > LONGEST) {
                seconds /= MachineSpeed.slowness();
            }
            write(String.format(Locale.ROOT, "%.2f\t%s\n", seconds, name(test)));
        }
    }

    /** The class or file that the case stands in, and what it is called there. */
    private static String name(TestIdentifier test) {
        String place = test.getUniqueId().replaceAll(".*\\[class:([^]]*)].*", "$1");
        return place + " " + test.getDisplayName().replaceAll("\\s+", " ");
    }

    /** At once, so that the times of a run that is stopped are known. */
    private static void write(String line) {
        String folder = System.getProperty("case.times");
        if (folder == null) {
            return;
        }
        Path file = Path.of(folder, ProcessHandle.current().pid() + ".tsv");
        try {
            Files.createDirectories(file.getParent());
            Files.writeString(file, line, StandardOpenOption.CREATE, StandardOpenOption.APPEND);
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
    }
}
