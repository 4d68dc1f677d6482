package arcomat.benchmarks.compositions;

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
    public Map<String, Measurement> measure() throws IOException {
        Map<String, Measurement> results = new LinkedHashMap<>();
        try {
            for (int size : SIZES) {
                measure(ComposedSystems.of("shift", size), results);
            }
        } catch (InterruptedException e) {
            throw new IOException(e);
        }
        return results;
    }

    private static void measure(ComposedSystem system, Map<String, Measurement> results)
            throws IOException, InterruptedException {
        String label = system.label();
        UserTime inMemory = UserTime.of(command(HEAP, system, List.of()));
        long pairs = AskedComposition.configurations(system, inMemory);
        Measurement.put(results, label + " pairs", pairs, "");
        add(results, label + " in memory", inMemory, pairs);
        double inProcess = inMemory.megabytes() * BYTES / pairs;
        Measurement.put(results, label + " in memory, bytes a pair", inProcess, "B");
        Path folder = Files.createTempDirectory("explored");
        try {
            List<String> more = List.of(AskedComposition.DISK, folder.toString());
            UserTime onDisk = UserTime.of(command(SMALL_HEAP, system, more));
            if (AskedComposition.configurations(system, onDisk) != pairs) {
                throw new IllegalStateException(label + ": " + onDisk.output());
            }
            add(results, label + " on disk", onDisk, pairs);
            double inFiles = (double) bytes(folder) / pairs;
            Measurement.put(results, label + " on disk, bytes a pair", inFiles, "B");
        } finally {
            Folders.delete(folder);
        }
    }

    private static List<String> command(String heap, ComposedSystem system, List<String> more) {
        List<String> all = new ArrayList<>(List.of(AskedComposition.EXPLICIT));
        all.addAll(more);
        return AskedComposition.command(heap, system, all);
    }

    private static void add(
            Map<String, Measurement> results, String label, UserTime time, long pairs) {
        Measurement.put(results, label, time.seconds(), "s");
        Measurement.put(results, label + ", pairs a second", pairs / time.seconds(), "/s");
        Measurement.put(results, label + ", a second by the clock", pairs / time.elapsed(), "/s");
        Measurement.put(results, label + ", memory", time.megabytes(), "MB");
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
