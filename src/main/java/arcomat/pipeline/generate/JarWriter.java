package arcomat.pipeline.generate;

import arcomat.brick.jar.RobotJar.RobotClass;
import arcomat.pipeline.file.ArchiveEntry;

import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.util.List;
import java.util.jar.Attributes;
import java.util.jar.JarFile;
import java.util.jar.Manifest;
import java.util.zip.CRC32;
import java.util.zip.ZipEntry;
import java.util.zip.ZipOutputStream;

/**
 * Writes a program's jar. The same classes give the same bytes: no dates, and no compression, whose
 * result differs from one Java to the next.
 */
final class JarWriter {
    private JarWriter() {}

    /**
     * @param main the main class
     * @param classes in the order of the jar's entries
     */
    static byte[] write(String main, List<RobotClass> classes) {
        ByteArrayOutputStream bytes = new ByteArrayOutputStream();
        try (ZipOutputStream jar = new ZipOutputStream(bytes)) {
            add(JarFile.MANIFEST_NAME, manifest(main), jar);
            for (RobotClass each : classes) {
                add(each.path(), each.bytes(), jar);
            }
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
        return bytes.toByteArray();
    }

    private static byte[] manifest(String main) throws IOException {
        Manifest manifest = new Manifest();
        manifest.getMainAttributes().put(Attributes.Name.MANIFEST_VERSION, "1.0");
        manifest.getMainAttributes().put(Attributes.Name.MAIN_CLASS, main);
        ByteArrayOutputStream bytes = new ByteArrayOutputStream();
        manifest.write(bytes);
        return bytes.toByteArray();
    }

    private static void add(String path, byte[] content, ZipOutputStream jar) throws IOException {
        CRC32 sum = new CRC32();
        sum.update(content);
        ZipEntry entry = ArchiveEntry.of(path);
        entry.setMethod(ZipEntry.STORED);
        entry.setSize(content.length);
        entry.setCrc(sum.getValue());
        jar.putNextEntry(entry);
        jar.write(content);
        jar.closeEntry();
    }
}
