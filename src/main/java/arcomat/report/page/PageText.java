package arcomat.report.page;

import arcomat.diagram.Theme;
import arcomat.report.text.Printable;

import java.util.List;
import java.util.Map;
import java.util.stream.Collectors;

/** Writes a page as HTML: the timeline of runs, and what stands beside it. */
public final class PageText {
    /** In the order in which they build on each other. */
    private static final List<String> SCRIPTS =
            List.of(
                    "elements.js",
                    "tracks.js",
                    "view.js",
                    "lanes.js",
                    "timeline.js",
                    "moment.js",
                    "picture/wires.js",
                    "picture/folds.js",
                    "picture/finder.js",
                    "picture/legend.js",
                    "picture/viewer.js",
                    "pictures.js",
                    "remarks.js",
                    "search.js",
                    "paper.js",
                    "stories.js",
                    "address.js",
                    "keys.js",
                    "main.js");

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
                        "data", PageData.render(page));
        String style = Theme.ADAPTIVE.css() + SelfContained.join(STYLES);
        return SelfContained.render("page.html", style, SCRIPTS, slots);
    }

    private static String pictures(Page page) {
        return PageData.pictures(page).keySet().stream()
                .map(svg -> "<template class=\"picture\">" + svg + "</template>\n")
                .collect(Collectors.joining());
    }
}
