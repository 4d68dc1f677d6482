package arcomat.pipeline.file;

import java.time.LocalDateTime;
import java.util.zip.ZipEntry;

/** Entries of archives whose bytes say neither when nor where the archive was written. */
public final class ArchiveEntry {
    /**
     * Not the first moment of 1980, where the dates of archives begin: Java takes that for a date
     * before it, and adds a field with the time in UTC, which differs from zone to zone.
     */
    private static final LocalDateTime DATE = LocalDateTime.of(1980, 2, 1, 0, 0);

    private ArchiveEntry() {}

    /**
     * @param path with forward slashes
     */
    public static ZipEntry of(String path) {
        ZipEntry entry = new ZipEntry(path);
        entry.setTimeLocal(DATE);
        return entry;
    }
}
