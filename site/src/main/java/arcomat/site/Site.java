package arcomat.site;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.LinkedHashMap;
import java.util.Map;

/** Makes the site. */
public final class Site {
    private final Repository repository;
    private final String version;
    private final Shelf shelf;

    private Site(Repository repository, String version) throws IOException {
        this.repository = repository;
        this.version = version;
        this.shelf = Shelf.of(repository);
    }

    /**
     * @param args the folder of the repository; the version; the address of the repository, where
     *     what is no page can be looked at; the live page; the jar of the search library; the
     *     folder to write
     */
    public static void main(String[] args) throws IOException {
        try {
            Site site = new Site(new Repository(Path.of(args[0]), args[2]), args[1]);
            site.write(Path.of(args[3]), Path.of(args[4]), Path.of(args[5]));
        } catch (BrokenPages e) {
            System.err.println(e.getMessage());
            System.exit(1);
        }
    }

    /**
     * Writes it into an empty folder.
     *
     * @param live the live page
     * @param search the jar of the search library
     * @throws BrokenPages where a link leads nowhere, or a page cannot be found
     */
    static void make(Repository repository, Path live, Path search, Path folder)
            throws IOException {
        new Site(repository, "0").write(live, search, folder);
    }

    private void write(Path live, Path search, Path target) throws IOException {
        Folder folder = new Folder(target);
        writePages(folder);
        folder.copy(live, "live/index.html");
        Assets.write(folder, repository, search);
    }

    private void writePages(Folder folder) throws IOException {
        Map<Path, Manuscript> manuscripts = Manuscript.all(repository);
        BrokenPages.Problems problems = new BrokenPages.Problems();
        Navigation navigation = Navigation.of(manuscripts, problems);
        Map<Path, Page> pages = new LinkedHashMap<>();
        Links links = new Links(repository, manuscripts.keySet());
        manuscripts.forEach(
                (path, manuscript) -> pages.put(path, Page.of(manuscript, links, shelf, problems)));
        Links.check(pages.values(), problems);
        problems.stop();
        Layout layout = new Layout(repository, version, navigation);
        for (Page page : pages.values()) {
            folder.write(page.address(), layout.html(page));
        }
        for (Path picture : links.pictures()) {
            folder.copy(repository.file(picture), picture.toString());
        }
        folder.write("assets/sections.js", SearchText.script(pages.values()));
    }

    /** Where the site comes to lie. */
    record Folder(Path root) {
        void write(String name, String text) throws IOException {
            Files.writeString(place(name), text);
        }

        void copy(Path file, String name) throws IOException {
            Files.write(place(name), Files.readAllBytes(file));
        }

        private Path place(String name) throws IOException {
            Path place = root.resolve(name);
            Files.createDirectories(place.getParent());
            return place;
        }
    }
}
