package arcomat.benchmarks.compositions;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;

/**
 * What a process took of processors and of memory: other work on the machine makes little
 * difference to that.
 *
 * @param seconds in its own code and that of its libraries, of all its threads
 * @param elapsed seconds by the clock, which other work and the disk make more
 * @param megabytes the most that was in memory at once
 * @param output what it printed
 */
record UserTime(double seconds, double elapsed, long megabytes, String output) {
    private static final double TICKS = 100;
    private static final double NANOSECONDS = 1e9;
    private static final int USER = 11;
    private static final long PAUSE = 5;

    /**
     * Looks at the figures that Linux keeps of a process again and again, until it has ended.
     *
     * @throws IllegalStateException where it fails
     */
    static UserTime of(List<String> command) throws IOException, InterruptedException {
        Path output = Files.createTempFile("output", ".txt");
        long begun = System.nanoTime();
        Process process =
                new ProcessBuilder(command)
                        .redirectErrorStream(true)
                        .redirectOutput(output.toFile())
                        .start();
        Path figures = Path.of("/proc", String.valueOf(process.pid()));
        double seconds = 0;
        long most = 0;
        while (process.isAlive()) {
            seconds = Math.max(seconds, seconds(figures));
            most = Math.max(most, megabytes(figures));
            Thread.sleep(PAUSE);
        }
        double elapsed = (System.nanoTime() - begun) / NANOSECONDS;
        String text = Files.readString(output);
        Files.delete(output);
        if (process.waitFor() != 0) {
            throw new IllegalStateException(command + " failed: " + text);
        }
        return new UserTime(seconds, elapsed, most, text.strip());
    }

    private static double seconds(Path figures) {
        String line = read(figures.resolve("stat"));
        String[] fields = line.substring(line.lastIndexOf(')') + 1).strip().split(" ");
        return fields.length > USER ? Long.parseLong(fields[USER]) / TICKS : 0;
    }

    private static long megabytes(Path figures) {
        return read(figures.resolve("status"))
                .lines()
                .filter(line -> line.startsWith("VmHWM:"))
                .mapToLong(line -> Long.parseLong(line.replaceAll("\\D", "")) / 1024)
                .findFirst()
                .orElse(0);
    }

    /** Empty where the process has ended meanwhile. */
    private static String read(Path file) {
        try {
            return Files.readString(file);
        } catch (IOException ended) {
            return "";
        }
    }
}
