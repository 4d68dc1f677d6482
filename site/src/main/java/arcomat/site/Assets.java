package arcomat.site;

import java.io.IOException;
import java.io.InputStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.List;
import java.util.Objects;
import java.util.zip.ZipEntry;
import java.util.zip.ZipFile;

/** Styles and scripts of the site; colours are those of reports. */
final class Assets {
    private static final String REPORT = "src/main/resources/report/";

    private Assets() {}

    /**
     * @param search the jar with the library that searches
     */
    static void write(Site.Folder folder, Repository repository, Path search) throws IOException {
        String colours = repository.read(Path.of(REPORT + "colours.css"));
        folder.write("assets/site.css", colours + own("site.css"));
        folder.write("assets/site.js", own("site.js"));
        folder.write("assets/search.js", library(search, "/lunr.min.js"));
        folder.write("assets/search-licence.txt", library(search, "/LICENSE"));
    }

    private static String own(String name) throws IOException {
        try (InputStream in = Assets.class.getResourceAsStream("/site/" + name)) {
            return text(Objects.requireNonNull(in));
        }
    }

    private static String library(Path jar, String end) throws IOException {
        try (ZipFile zip = new ZipFile(jar.toFile())) {
            List<? extends ZipEntry> found =
                    zip.stream().filter(entry -> entry.getName().endsWith(end)).toList();
            if (found.size() != 1) {
                throw new IllegalStateException(jar + " has " + found + " for " + end);
            }
            try (InputStream in = zip.getInputStream(found.get(0))) {
                return text(in);
            }
        }
    }

    private static String text(InputStream in) throws IOException {
        return new String(in.readAllBytes(), StandardCharsets.UTF_8);
    }
}
