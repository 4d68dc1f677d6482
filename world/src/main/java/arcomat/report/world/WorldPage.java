package arcomat.report.world;

import arcomat.report.page.Page;
import arcomat.report.page.PageText;
import arcomat.report.page.SelfContained;
import arcomat.report.page.Story;
import arcomat.report.run.RunDrawings;
import arcomat.report.run.TracePage;
import arcomat.simulate.run.RobotRun;
import arcomat.world.Recording;

import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.stream.Stream;

/** A run of a world as a page that plays it again. */
public final class WorldPage {
    private static final List<String> STYLES = List.of("replay/replay.css", "replay/floor.css");

    private static final List<String> SCRIPTS =
            List.of(
                    "address.js",
                    "replay/inside.js",
                    "replay/recording.js",
                    "replay/labels.js",
                    "replay/ghost.js",
                    "replay/floor.js",
                    "replay/cards.js",
                    "replay/happenings.js",
                    "replay/player.js",
                    "replay/stage.js",
                    "replay/replay.js");

    private WorldPage() {}

    /**
     * @param inside what the programs of robots did
     * @param title what ran, such as the name of the world's file
     */
    public static String render(Recording recording, List<RobotRun> inside, String title) {
        return render(recording, inside, Optional.empty(), title);
    }

    /**
     * The same with another run on its floor.
     *
     * @param inside what the programs of robots did
     * @param title what ran, such as the name of the world's file
     */
    public static String render(
            Recording recording, List<RobotRun> inside, Optional<Ghost> ghost, String title) {
        RunDrawings pictures = new RunDrawings();
        List<Story> stories =
                inside.stream()
                        .filter(each -> !each.times().isEmpty())
                        .map(each -> story(each, pictures))
                        .toList();
        Page runs = new Page("world", title, Page.Tone.NEUTRAL, "", stories);
        Map<String, String> slots =
                Map.of(
                        "title", SelfContained.escaped(title),
                        "headline", SelfContained.escaped(WorldText.summary(recording)),
                        "tone", recording.succeeded() ? "good" : "bad",
                        "data",
                                SelfContained.harmless(
                                        WorldJson.render(recording, PacketWords.of(inside), ghost)),
                        "pictures", PageText.pictures(runs),
                        "inside", PageText.data(runs));
        String style = PageText.runStyle() + SelfContained.join(STYLES);
        List<String> scripts =
                Stream.concat(PageText.runScripts().stream(), SCRIPTS.stream()).toList();
        return SelfContained.render("replay/replay.html", style, scripts, slots);
    }

    private static Story story(RobotRun run, RunDrawings pictures) {
        return TracePage.story(run.robot(), run.trace(), run.times(), pictures);
    }
}
