package arcomat.pipeline.check;

import arcomat.check.guest.GuestLaws;
import arcomat.pipeline.Session;

import java.io.IOException;
import java.io.InputStream;
import java.io.UncheckedIOException;
import java.net.URI;
import java.net.URISyntaxException;
import java.net.URL;
import java.nio.charset.StandardCharsets;
import java.nio.file.FileSystem;
import java.nio.file.FileSystems;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.SortedMap;
import java.util.TreeMap;
import java.util.stream.Stream;

/**
 * The pages about the codes of findings, {@code explain/ARCnnnn.md} in the tool's own resources.
 */
public final class Explanations {
    private static final String FOLDER = "/explain";

    private Explanations() {}

    /**
     * The page of a code, in Markdown, by the tool or the guest that has it; the code in any case
     * and without {@code ARC} if need be.
     */
    public static Optional<String> page(String code, Session session) {
        String name = code.strip().toUpperCase(Locale.ROOT);
        return session.laws().page(name).or(() -> own(name));
    }

    private static Optional<String> own(String code) {
        String name = code;
        if (name.matches("[0-9]{4}")) {
            name = "ARC" + name;
        }
        if (!name.matches("ARC[0-9]{4}")) {
            return Optional.empty();
        }
        try (InputStream in = Explanations.class.getResourceAsStream(FOLDER + "/" + name + ".md")) {
            return in == null
                    ? Optional.empty()
                    : Optional.of(new String(in.readAllBytes(), StandardCharsets.UTF_8));
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
    }

    /** Every code with the title of its page; that of a guest's law may have none. */
    public static SortedMap<String, String> titles(Session session) {
        SortedMap<String, String> titles = titles();
        for (GuestLaws guest : session.laws().guests()) {
            for (String code : guest.codes()) {
                String page = guest.pages().apply(code).orElse("");
                titles.put(code, title(page.lines().findFirst().orElse("")));
            }
        }
        return titles;
    }

    /** Those of the tool. */
    public static SortedMap<String, String> titles() {
        URL folder = Explanations.class.getResource(FOLDER);
        try {
            URI uri = folder.toURI();
            if (!uri.getScheme().equals("jar")) {
                return titles(Path.of(uri));
            }
            try (FileSystem jar = FileSystems.newFileSystem(uri, Map.of())) {
                return titles(jar.getPath(FOLDER));
            }
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        } catch (URISyntaxException e) {
            throw new IllegalStateException(e);
        }
    }

    private static SortedMap<String, String> titles(Path folder) throws IOException {
        SortedMap<String, String> titles = new TreeMap<>();
        try (Stream<Path> pages = Files.list(folder)) {
            for (Path page : (Iterable<Path>) pages::iterator) {
                String code = page.getFileName().toString().replace(".md", "");
                String heading = Files.readString(page).lines().findFirst().orElse("");
                titles.put(code, title(heading));
            }
        }
        return titles;
    }

    private static String title(String heading) {
        return heading.replaceFirst("^# *([A-Z]+[0-9]{4})? *", "");
    }
}
