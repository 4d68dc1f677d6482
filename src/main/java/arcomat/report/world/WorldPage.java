package arcomat.report.world;

import arcomat.diagram.Theme;
import arcomat.report.page.SelfContained;
import arcomat.world.Recording;

import java.util.List;
import java.util.Map;

/** A run of a world as a page that plays it again. */
public final class WorldPage {
    private static final List<String> STYLES =
            List.of("colours.css", "page.css", "replay/replay.css", "replay/floor.css");

    private static final List<String> SCRIPTS =
            List.of(
                    "elements.js",
                    "replay/recording.js",
                    "replay/floor.js",
                    "replay/cards.js",
                    "replay/happenings.js",
                    "replay/player.js",
                    "replay/stage.js",
                    "replay/replay.js");

    private WorldPage() {}

    /**
     * @param title what ran, such as the name of the world's file
     */
    public static String render(Recording recording, String title) {
        Map<String, String> slots =
                Map.of(
                        "title", SelfContained.escaped(title),
                        "headline", SelfContained.escaped(WorldText.summary(recording)),
                        "tone", recording.succeeded() ? "good" : "bad",
                        "data", SelfContained.harmless(WorldJson.render(recording)));
        String style = Theme.ADAPTIVE.css() + SelfContained.join(STYLES);
        return SelfContained.render("replay/replay.html", style, SCRIPTS, slots);
    }
}
