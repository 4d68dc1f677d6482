package arcomat.report.page;

import arcomat.diagram.Theme;

import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.function.Function;
import java.util.stream.Collectors;

/** A page that shows the pictures of a folder, one below the other, each in a window. */
public final class GalleryPage {
    private static final List<String> STYLES =
            List.of("colours.css", "page.css", "picture/viewer.css", "gallery/gallery.css");

    private static final List<String> SCRIPTS =
            List.of(
                    "picture/wires.js",
                    "picture/folds.js",
                    "picture/shrinking.js",
                    "picture/finder.js",
                    "picture/legend.js",
                    "picture/viewer.js",
                    "gallery/gallery.js");

    private GalleryPage() {}

    /**
     * A picture of the folder.
     *
     * @param file beside the page
     * @param svg an element {@code svg} without scripts and styles; empty where the file is an
     *     image
     */
    public record Entry(String file, Optional<String> svg) {
        String name() {
            return file.substring(0, file.lastIndexOf('.'));
        }
    }

    public static String render(String title, List<Entry> entries) {
        Map<String, String> slots =
                Map.of(
                        "title", SelfContained.escaped(title),
                        "names", all(entries, GalleryPage::link),
                        "pictures", all(entries, GalleryPage::section));
        String style = Theme.ADAPTIVE.css() + SelfContained.join(STYLES);
        return SelfContained.render("gallery/gallery.html", style, SCRIPTS, slots);
    }

    private static String all(List<Entry> entries, Function<Entry, String> markup) {
        return entries.stream().map(markup).collect(Collectors.joining());
    }

    private static String link(Entry entry) {
        String name = SelfContained.escaped(entry.name());
        return "<li data-picture=\"%s\"><a href=\"#%s\">%s</a></li>\n".formatted(name, name, name);
    }

    private static String section(Entry entry) {
        String name = SelfContained.escaped(entry.name());
        String file = SelfContained.escaped(entry.file());
        String picture =
                entry.svg()
                        .orElse(
                                "<img loading=\"lazy\" alt=\"%s\" src=\"%s\">\n"
                                        .formatted(name, file));
        return "<section id=\"%s\">\n<h2><a href=\"%s\">%s</a></h2>\n%s</section>\n"
                .formatted(name, file, name, picture);
    }
}
