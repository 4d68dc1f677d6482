package arcomat.brick.api;

import java.io.IOException;
import java.io.OutputStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.LocalDateTime;
import java.util.Comparator;
import java.util.List;
import java.util.zip.ZipEntry;
import java.util.zip.ZipOutputStream;

/** Packs the stubs of all classes into one jar. */
public final class StubJar {
    /**
     * Jars of one table are the same at any time and in any zone. With the first moment of 1980,
     * which Java takes for a date before those of archives, entries would have a field with the
     * time in UTC.
     */
    private static final LocalDateTime NO_DATE = LocalDateTime.of(1980, 2, 1, 0, 0);

    private StubJar() {}

    /** The build step: writes the jar of the shipped table to the path given as first argument. */
    public static void main(String[] arguments) throws IOException {
        Path file = Path.of(arguments[0]);
        Files.createDirectories(file.toAbsolutePath().getParent());
        try (OutputStream out = Files.newOutputStream(file)) {
            write(BrickTable.leJos(), out);
        }
    }

    public static void write(BrickTable table, OutputStream out) throws IOException {
        StubWriter stubs = new StubWriter(table);
        List<BrickType> sorted =
                table.types().stream().sorted(Comparator.comparing(BrickType::name)).toList();
        ZipOutputStream zip = new ZipOutputStream(out);
        for (BrickType type : sorted) {
            ZipEntry entry = new ZipEntry(type.name() + ".class");
            entry.setTimeLocal(NO_DATE);
            zip.putNextEntry(entry);
            zip.write(stubs.write(type));
            zip.closeEntry();
        }
        zip.finish();
    }
}
