package arcomat.report.page;

import arcomat.diagram.Theme;
import arcomat.report.text.Printable;

import java.util.List;
import java.util.Map;
import java.util.stream.Collectors;
import java.util.stream.Stream;

/** Writes a page as HTML: the timeline of runs, and what stands beside it. */
public final class PageText {
    /** Runs, in the order in which they build on each other. */
    private static final List<String> RUN_SCRIPTS =
            List.of(
                    "elements.js",
                    "tracks.js",
                    "view.js",
                    "lanes.js",
                    "rows.js",
                    "timeline.js",
                    "moment.js",
                    "picture/wires.js",
                    "picture/folds.js",
                    "picture/shrinking.js",
                    "picture/finder.js",
                    "picture/legend.js",
                    "picture/viewer.js",
                    "carried.js",
                    "pictures.js",
                    "remarks.js",
                    "search.js",
                    "paper.js",
                    "play.js",
                    "stories.js");

    private static final List<String> STYLES =
            List.of(
                    "colours.css",
                    "page.css",
                    "timeline.css",
                    "moment.css",
                    "picture/viewer.css",
                    "paper.css");

    private PageText() {}

    public static String render(Page page) {
        Map<String, String> slots =
                Map.of(
                        "title", SelfContained.escaped(page.title()),
                        "command", SelfContained.escaped(page.command()),
                        "tone", Printable.word(page.tone()),
                        "headline", SelfContained.escaped(page.headline()),
                        "pictures", pictures(page),
                        "data", data(page));
        List<String> scripts =
                Stream.concat(RUN_SCRIPTS.stream(), Stream.of("address.js", "keys.js", "main.js"))
                        .toList();
        return SelfContained.render("page.html", runStyle(), scripts, slots);
    }

    /** Scripts of pages that show runs as this one does, whatever else is on them. */
    public static List<String> runScripts() {
        return RUN_SCRIPTS;
    }

    public static String runStyle() {
        return Theme.ADAPTIVE.css() + SelfContained.join(STYLES);
    }

    /** The runs of a page as JSON that may stand in HTML, {@code {"stories": []}}. */
    public static String data(Page page) {
        return PageData.render(page);
    }

    /** The pictures of its runs, as templates. */
    public static String pictures(Page page) {
        return PageData.pictures(page).keySet().stream()
                .map(svg -> "<template class=\"picture\">" + svg + "</template>\n")
                .collect(Collectors.joining());
    }
}
