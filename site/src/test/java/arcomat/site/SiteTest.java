package arcomat.site;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import org.jsoup.Jsoup;
import org.jsoup.nodes.Document;
import org.jsoup.nodes.Element;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

import java.io.IOException;
import java.net.URI;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.LinkedHashMap;
import java.util.Map;
import java.util.TreeMap;
import java.util.stream.Stream;

/** The site, read as a browser reads it: by what lies in its folder. */
class SiteTest {
    private static final Path SEARCH = Path.of(System.getProperty("site.scripts"));
    private static final String HOME = System.getProperty("site.home");

    @TempDir static Path folder;

    private static Path site;
    private static Map<Path, Document> pages;

    @BeforeAll
    static void make() throws IOException {
        site = make("site");
        pages = new TreeMap<>();
        for (Path file : files(site)) {
            if (file.toString().endsWith(".html")) {
                pages.put(file, Jsoup.parse(file.toFile(), "UTF-8"));
            }
        }
        assertThat(pages).hasSizeGreaterThan(200);
    }

    private static Path make(String name) throws IOException {
        Path live = Files.writeString(folder.resolve("live.html"), "<h1 id='see'>Live</h1>");
        Path made = folder.resolve(name);
        Site.make(new Repository(Path.of(""), HOME), live, SEARCH, made);
        return made;
    }

    private static Iterable<Path> files(Path root) throws IOException {
        try (Stream<Path> files = Files.walk(root)) {
            return files.filter(Files::isRegularFile).sorted().toList();
        }
    }

    @Test
    void everyLinkLeadsToAFileAndItsAnchorToAPlaceInIt() {
        pages.forEach(
                (path, page) -> {
                    for (Element link : page.select("a[href]")) {
                        String href = link.attr("href");
                        if (!href.startsWith("https:") && !link.hasClass("try")) {
                            check(path, href);
                        }
                    }
                });
    }

    private static void check(Path page, String href) {
        URI address = URI.create(href);
        Path target =
                address.getPath().isEmpty()
                        ? page
                        : page.resolveSibling(address.getPath()).normalize();
        assertThat(target).as("%s: %s", page, href).isRegularFile();
        if (address.getFragment() != null) {
            assertThat(pages.get(target).getElementById(address.getFragment()))
                    .as("%s: %s", page, href)
                    .isNotNull();
        }
    }

    /** What is no page is there all the same: a link out of the site is one into the repository. */
    @Test
    void whatIsNoPageIsInTheRepository() {
        Stream<String> outside =
                pages.values().stream()
                        .flatMap(page -> page.select("a[href^=" + HOME + "]").stream())
                        .map(link -> link.attr("href").substring(HOME.length()));
        assertThat(outside)
                .isNotEmpty()
                .allSatisfy(
                        each ->
                                assertThat(Path.of(each.replaceFirst("/(blob|tree)/main/", "")))
                                        .exists());
    }

    /** A reader is between the page and nobody else. */
    @Test
    void nothingIsLoadedFromElsewhere() {
        pages.forEach(
                (path, page) -> {
                    for (Element each : page.select("[src], link[href]:not([rel=icon])")) {
                        String name = each.hasAttr("src") ? each.attr("src") : each.attr("href");
                        assertThat(path.resolveSibling(name)).as("%s", path).isRegularFile();
                    }
                });
    }

    @Test
    void everyPageOfTheDocumentationHasATitleAndAPlaceInTheContents() throws IOException {
        try (Stream<Path> texts = Files.walk(Path.of("docs"))) {
            texts.filter(each -> each.toString().endsWith(".md"))
                    .forEach(
                            text -> {
                                Path path = site.resolve(Addresses.of(text));
                                assertThat(pages.get(path).select("main h1").text()).isNotEmpty();
                                assertThat(pages.get(path).select(".contents [aria-current]"))
                                        .as("%s", text)
                                        .hasSize(text.equals(Repository.CONTENTS) ? 0 : 1);
                            });
        }
    }

    @Test
    void noTwoPlacesOfAPageShareAName() {
        pages.forEach(
                (path, page) ->
                        assertThat(page.select("[id]").eachAttr("id"))
                                .as("%s", path)
                                .doesNotHaveDuplicates());
    }

    @Test
    void theSameTextsGiveTheSameBytes() throws IOException {
        Path again = make("again");
        Map<String, String> first = bytes(site);
        assertThat(bytes(again)).isEqualTo(first);
    }

    private static Map<String, String> bytes(Path root) throws IOException {
        Map<String, String> bytes = new LinkedHashMap<>();
        for (Path file : files(root)) {
            bytes.put(root.relativize(file).toString(), Files.readString(file));
        }
        return bytes;
    }

    /** A terminal shows its commands apart from what they print, and codes lead to their pages. */
    @Test
    void transcriptsLeadToThePagesAboutFindings() {
        Document tutorial = pages.get(site.resolve("docs/tutorial.html"));
        assertThat(tutorial.select(".console kbd").eachText())
                .contains("arcomat check src/main/arc");
        Element code = tutorial.selectFirst(".console a[href]");
        assertThat(code.text()).isEqualTo("ARC0329");
        assertThat(code.attr("href")).isEqualTo("../findings/ARC0329.html");
    }

    @Test
    void linksThatLeadNowhereAreToldAll() throws IOException {
        Path texts = folder.resolve("broken");
        write(texts, "README.md", "# A\n\n[gone](docs/gone.md) [b](docs/b.md#nothing)\n");
        write(texts, "docs/README.md", "# Docs\n\n| all | |\n|---|---|\n| [b](b.md) | |\n");
        write(texts, "docs/b.md", "# B\n\n![none](none.svg) [self](#b) [no](#c)\n");
        write(texts, "docs/lost.md", "# Lost\n");
        write(texts, "models/m.cd", "");
        write(texts, "lejos-runtime/nxt/src/main/arc/n.cd", "");
        Path live = folder.resolve("live.html");
        assertThatThrownBy(
                        () ->
                                Site.make(
                                        new Repository(texts, HOME),
                                        live,
                                        SEARCH,
                                        folder.resolve("none")))
                .isInstanceOf(BrokenPages.class)
                .hasMessage(
                        """
                        README.md: leads to docs/b.html#nothing, a heading that is not there
                        README.md: leads to docs/gone.md, which is not there
                        docs/README.md: does not name docs/lost.md
                        docs/b.md: leads to #c, a heading that is not there
                        docs/b.md: no picture docs/none.svg\
                        """);
    }

    private static void write(Path root, String name, String text) throws IOException {
        Path file = root.resolve(name);
        Files.createDirectories(file.getParent());
        Files.writeString(file, text);
    }
}
