package arcomat.testing;

import com.sun.management.OperatingSystemMXBean;

import java.io.IOException;
import java.lang.management.ManagementFactory;
import java.nio.file.DirectoryStream;
import java.nio.file.Files;
import java.nio.file.Path;

/** Processor time of this process. */
final class ProcessorTime {
    /** On Linux, where the kernel says how long a process and the children it awaited took. */
    private static final Path STATISTICS = Path.of("/proc/self/stat");

    /** User and system time of the process, then those of its children, behind its name. */
    private static final int FIRST = 11;

    private static final int LAST = 14;

    /** Of a thread, children are those of its process. */
    private static final int LAST_OF_THREAD = 12;

    private static final Path THREADS = Path.of("/proc/self/task");

    /** The kernel keeps fifteen letters of "C1 CompilerThread0". */
    private static final String COMPILER = " CompilerThre";

    /** The kernel counts in hundredths of a second, whatever the machine. */
    private static final double TICKS = 100;

    private ProcessorTime() {}

    /**
     * Seconds of all threads, with those of awaited children where the system tells. The time of
     * Java's compiler is left out: it depends on which case of a process comes first.
     */
    static double seconds() {
        return ofProcess() - ofCompiler();
    }

    private static double ofProcess() {
        try {
            return Files.isReadable(STATISTICS) ? ofKernel() : ofThreads();
        } catch (IOException e) {
            return ofThreads();
        }
    }

    private static double ofKernel() throws IOException {
        return seconds(Files.readString(STATISTICS), LAST);
    }

    /** Nothing where the system does not tell the times of threads. */
    private static double ofCompiler() {
        double sum = 0;
        try (DirectoryStream<Path> threads = Files.newDirectoryStream(THREADS)) {
            for (Path thread : threads) {
                sum += ofCompiler(thread);
            }
        } catch (IOException e) {
            return 0;
        }
        return sum;
    }

    private static double ofCompiler(Path thread) {
        try {
            String text = Files.readString(thread.resolve("stat"));
            return text.contains(COMPILER) ? seconds(text, LAST_OF_THREAD) : 0;
        } catch (IOException e) {
            return 0; // it has ended since the folder was read
        }
    }

    /** From what the kernel says of a process or a thread. */
    private static double seconds(String statistics, int last) {
        String[] fields = statistics.substring(statistics.lastIndexOf(')') + 2).split(" ");
        double ticks = 0;
        for (int i = FIRST; i <= last; i++) {
            ticks += Long.parseLong(fields[i]);
        }
        return ticks / TICKS;
    }

    private static double ofThreads() {
        var system = (OperatingSystemMXBean) ManagementFactory.getOperatingSystemMXBean();
        return system.getProcessCpuTime() / 1e9;
    }
}
