package arcomat.pipeline.file;

import arcomat.pipeline.PathNames;
import arcomat.pipeline.Session;
import arcomat.pipeline.WrongUse;
import arcomat.report.page.Page;
import arcomat.report.page.PageText;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;

/**
 * The page {@value #NAME} of a report folder. It is replaced as a whole or not at all, and only if
 * it is such a page already.
 */
public final class ReportPage {
    public static final String NAME = "index.html";

    /** What every page says of itself. */
    private static final String MARK = "<meta name=\"generator\" content=\"arcomat\">";

    /** The mark is within that many characters. */
    private static final int BEGINNING = 2000;

    private final Path folder;
    private final String written;

    /**
     * @param written the folder as the user wrote it
     */
    public ReportPage(String written, PathNames names) {
        this.folder = names.resolve(written);
        this.written = written;
    }

    /**
     * Writes a page into a folder, and tells that it does so.
     *
     * @param folder as the user wrote it; it is made if need be
     * @throws WrongUse where it cannot be written
     */
    public static void write(Page page, String folder, Session session) throws WrongUse {
        session.progress().step("writing " + folder + "/" + NAME);
        new ReportPage(folder, session.names()).write(PageText.render(page));
    }

    /**
     * Finds out before any work is done whether a page can be written; makes nothing.
     *
     * @throws WrongUse where it cannot
     */
    public void requireWritable() throws WrongUse {
        if (written.isBlank()) {
            throw new WrongUse("--report names a folder, such as build/report");
        }
        Path existing = folder.toAbsolutePath().normalize();
        while (existing != null && !Files.exists(existing)) {
            existing = existing.getParent();
        }
        if (existing == null || !Files.isDirectory(existing)) {
            boolean itself =
                    existing != null && existing.equals(folder.toAbsolutePath().normalize());
            throw new WrongUse(
                    itself
                            ? "'" + written + "' is a file; --report names a folder"
                            : "cannot write to '%s': a file is in the way of a folder"
                                    .formatted(written));
        }
        if (!Files.isWritable(existing)) {
            throw new WrongUse("cannot write to '" + written + "': permission denied");
        }
        requireOwnPage();
    }

    private void requireOwnPage() throws WrongUse {
        Path page = folder.resolve(NAME);
        if (Files.isDirectory(page)) {
            throw new WrongUse("'" + written + "/" + NAME + "' is a folder");
        }
        try {
            if (Files.exists(page) && !isOwn(page)) {
                throw new WrongUse(
                        "'%s' holds a page that arcomat did not write; name another folder with"
                                + " --report, or move %s away",
                        written, NAME);
            }
        } catch (IOException e) {
            throw failed(e);
        }
    }

    private static boolean isOwn(Path page) throws IOException {
        try (var in = Files.newInputStream(page)) {
            String beginning =
                    new String(in.readNBytes(BEGINNING), java.nio.charset.StandardCharsets.UTF_8);
            return beginning.contains(MARK);
        }
    }

    /**
     * Writes the page; the folder is made if need be.
     *
     * @throws WrongUse where {@link #requireWritable} throws, or writing fails
     */
    public void write(String html) throws WrongUse {
        requireWritable();
        try {
            Files.createDirectories(folder);
            AtomicFile.write(folder.resolve(NAME), html);
        } catch (IOException e) {
            throw failed(e);
        }
    }

    private WrongUse failed(IOException e) {
        return Failures.cannot("write to", written, e);
    }
}
