package arcomat.benchmarks.compositions;

import arcomat.benchmarks.measure.Command;
import arcomat.benchmarks.measure.Folders;
import arcomat.benchmarks.measure.Goal;
import arcomat.benchmarks.measure.Group;
import arcomat.benchmarks.measure.Measurement;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.stream.Stream;

/**
 * The same shift registers explored in memory, and in files with a heap that holds few of their
 * pairs: how many pairs a second, by the clock too, and what each of them takes.
 */
public final class DiskGroup implements Group {
    private static final List<Integer> SIZES = List.of(20, 22);
    private static final String HEAP = "6g";
    private static final String SMALL_HEAP = "256m";
    private static final double BYTES = 1024 * 1024;

    @Override
    public String name() {
        return "disk";
    }

    @Override
    public List<Class<?>> benchmarks() {
        return List.of();
    }

    @Override
    public List<String> prepare() {
        return List.of();
    }

    @Override
    public Map<String, Measurement> measure() throws IOException {
        Map<String, Measurement> results = new LinkedHashMap<>();
        try {
            for (int size : SIZES) {
                measure(size, results);
            }
        } catch (InterruptedException e) {
            throw new IOException(e);
        }
        return results;
    }

    private static void measure(int size, Map<String, Measurement> results)
            throws IOException, InterruptedException {
        String label = "shift " + size;
        UserTime inMemory = UserTime.of(command(HEAP, size, List.of()));
        long pairs = pairs(label, inMemory);
        put(results, label + " pairs", pairs, "");
        add(results, label + " in memory", inMemory, pairs);
        put(results, label + " in memory, bytes a pair", inMemory.megabytes() * BYTES / pairs, "B");
        Path folder = Files.createTempDirectory("explored");
        try {
            List<String> more = List.of(AskedComposition.DISK, folder.toString());
            UserTime onDisk = UserTime.of(command(SMALL_HEAP, size, more));
            if (pairs(label, onDisk) != pairs) {
                throw new IllegalStateException(label + ": " + onDisk.output());
            }
            add(results, label + " on disk", onDisk, pairs);
            put(results, label + " on disk, bytes a pair", (double) bytes(folder) / pairs, "B");
        } finally {
            Folders.delete(folder);
        }
    }

    private static List<String> command(String heap, int size, List<String> more) {
        List<String> arguments =
                new ArrayList<>(List.of("shift", String.valueOf(size), AskedComposition.EXPLICIT));
        arguments.addAll(more);
        return Command.java(heap, AskedComposition.class, arguments);
    }

    private static long pairs(String label, UserTime time) {
        if (!time.output().startsWith("HOLDS ")) {
            throw new IllegalStateException(label + ": " + time.output());
        }
        return Long.parseLong(time.output().split(" ")[1]);
    }

    private static void add(
            Map<String, Measurement> results, String label, UserTime time, long pairs) {
        put(results, label, time.seconds(), "s");
        put(results, label + ", pairs a second", pairs / time.seconds(), "/s");
        put(results, label + ", a second by the clock", pairs / time.elapsed(), "/s");
        put(results, label + ", memory", time.megabytes(), "MB");
    }

    private static void put(
            Map<String, Measurement> results, String label, double value, String unit) {
        results.put(label, Measurement.of(label, List.of(value), unit));
    }

    private static long bytes(Path folder) throws IOException {
        try (Stream<Path> files = Files.walk(folder)) {
            return files.filter(Files::isRegularFile).mapToLong(DiskGroup::size).sum();
        }
    }

    private static long size(Path file) {
        try {
            return Files.size(file);
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
    }

    /** Nothing was promised; what was measured is in the documentation. */
    @Override
    public List<Goal> goals() {
        return List.of();
    }
}
