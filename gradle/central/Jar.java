import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.LocalDateTime;
import java.util.Map;
import java.util.zip.ZipEntry;
import java.util.zip.ZipOutputStream;

/** Writes jars that are the same in every run. */
final class Jar {
    /** Where zip begins, with a margin: at the first moment of 1980 Java adds the time in UTC. */
    private static final LocalDateTime FIXED_TIME = LocalDateTime.of(1980, 2, 1, 0, 0);

    private static final int MANIFEST_LINE = 70;

    /**
     * @param classPath names of jars beside this one, or null
     */
    static void write(Path file, Map<String, byte[]> entries, String classPath) throws IOException {
        try (ZipOutputStream zip = new ZipOutputStream(Files.newOutputStream(file))) {
            zip.setLevel(1);
            put(zip, "META-INF/MANIFEST.MF", manifest(classPath).getBytes(StandardCharsets.UTF_8));
            for (Map.Entry<String, byte[]> entry : entries.entrySet()) {
                put(zip, entry.getKey(), entry.getValue());
            }
        }
    }

    private static String manifest(String classPath) {
        StringBuilder text = new StringBuilder("Manifest-Version: 1.0\r\n");
        if (classPath != null) {
            String line = "Class-Path: " + classPath;
            while (line.length() > MANIFEST_LINE) {
                text.append(line, 0, MANIFEST_LINE).append("\r\n");
                line = " " + line.substring(MANIFEST_LINE);
            }
            text.append(line).append("\r\n");
        }
        return text.append("\r\n").toString();
    }

    private static void put(ZipOutputStream zip, String name, byte[] content) throws IOException {
        ZipEntry entry = new ZipEntry(name);
        entry.setTimeLocal(FIXED_TIME);
        zip.putNextEntry(entry);
        zip.write(content);
        zip.closeEntry();
    }
}
