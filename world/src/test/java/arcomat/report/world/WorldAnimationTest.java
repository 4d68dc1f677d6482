package arcomat.report.world;

import static org.assertj.core.api.Assertions.assertThat;

import arcomat.source.SourceFile;
import arcomat.world.Pose;
import arcomat.world.Recording;
import arcomat.world.Recording.Event;
import arcomat.world.Recording.Frame;
import arcomat.world.Recording.RobotFrame;
import arcomat.world.Scene.Happening;
import arcomat.world.Scene.Happening.What;
import arcomat.world.Seeds;
import arcomat.world.World;
import arcomat.world.World.Cup;
import arcomat.world.WorldParser;

import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.constraints.IntRange;
import net.jqwik.api.constraints.Size;

import org.junit.jupiter.api.Test;
import org.w3c.dom.Document;
import org.w3c.dom.Element;
import org.w3c.dom.NodeList;
import org.xml.sax.InputSource;

import java.io.StringReader;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.stream.IntStream;

import javax.xml.parsers.DocumentBuilderFactory;

/** A run as a picture that moves: all of the way, and nothing of a program but texts. */
class WorldAnimationTest {
    private static final String NASTY = "</text><script>&amp;";

    private static Recording recording() {
        String text =
                "floor 1000 800\nkind rover\nprogram jar r.jar\nbody 80 900\n"
                        + "wheels A B diameter 56 track 112\nlight S2\n"
                        + "robot one rover at 100 300\n";
        World world = WorldParser.parse(new SourceFile("w", text)).world().orElseThrow();
        List<Frame> frames =
                IntStream.rangeClosed(0, 20)
                        .mapToObj(i -> new Frame(100 * i, List.of(robot(i)), List.of(), List.of()))
                        .toList();
        return new Recording(
                world,
                Seeds.of(1),
                frames,
                List.of(new Event.Happened(500, new Happening(What.COLLISION, "one", ""))),
                Map.of(),
                List.of(),
                List.of(),
                List.of());
    }

    /** Ahead for a second, with a cup from then on; then it turns on the spot. */
    private static RobotFrame robot(int i) {
        Pose pose =
                new Pose(
                        100 + 10 * Math.min(i, 10), 300, i < 10 ? 0 : Math.toRadians(9 * (i - 10)));
        Cup cup = i < 10 ? Cup.NONE : Cup.FULL;
        return new RobotFrame(pose, 0, 0, List.of(75), cup, i < 5 ? NASTY : "", 0, false);
    }

    private static Document picture() throws Exception {
        String svg = WorldAnimation.render(recording(), NASTY);
        return DocumentBuilderFactory.newInstance()
                .newDocumentBuilder()
                .parse(new InputSource(new StringReader(svg)));
    }

    @Test
    void straightMotionHasTwoEnds() throws Exception {
        String style = picture().getElementsByTagName("style").item(0).getTextContent();
        assertThat(style)
                .contains(
                        "0.00% { transform: translate(100px, 500px) rotate(0deg) }"
                                + " 47.00% { transform: translate(200px, 500px) rotate(0deg) }"
                                + " 94.00% { transform: translate(200px, 500px) rotate(-90deg) }"
                                + " 100% {")
                .contains(
                        "0.00% { visibility: hidden } 47.00% { visibility: visible } 100% {"
                                + " visibility: visible }");
    }

    @Test
    void whatIsSeenForAWhileComesAndGoes() throws Exception {
        Element collision = ofKind(picture(), "collision");
        assertThat(collision.getAttribute("style")).contains("visibility: hidden", "step-end");
        assertThat(ofKind(picture(), "cup full").getAttribute("r")).isEqualTo("28");
        assertThat(ofKind(picture(), "doing").getTextContent()).isEqualTo(NASTY);
    }

    private static Element ofKind(Document picture, String kind) {
        NodeList all = picture.getElementsByTagName("*");
        return IntStream.range(0, all.getLength())
                .mapToObj(i -> (Element) all.item(i))
                .filter(each -> each.getAttribute("class").equals(kind))
                .findFirst()
                .orElseThrow();
    }

    @Test
    void runsNothingAndLoadsNothing() throws Exception {
        Document picture = picture();
        assertThat(picture.getElementsByTagName("script").getLength()).isZero();
        assertThat(picture.getElementsByTagName("title").item(0).getTextContent()).isEqualTo(NASTY);
        assertThat(WorldAnimation.render(recording(), "w"))
                .doesNotContain("href", "url(", "@import");
    }

    /** Whoever follows the frames that stay is never far from where the robot was. */
    @Property(tries = 200)
    void framesThatStayShowTheWay(
            @ForAll @Size(min = 1, max = 40) List<@IntRange(min = -20, max = 20) Integer> steps) {
        List<Motion.Place> way = new ArrayList<>();
        double x = 0;
        for (int i = 0; i < steps.size(); i++) {
            x += steps.get(i) / 5;
            way.add(new Motion.Place(x, i, 0));
        }
        List<Integer> kept = Motion.frames(way);
        assertThat(kept).startsWith(0).endsWith(way.size() - 1).isSorted().doesNotHaveDuplicates();
        for (int i = 0; i + 1 < kept.size(); i++) {
            int from = kept.get(i);
            int to = kept.get(i + 1);
            for (int j = from; j <= to; j++) {
                double straight =
                        way.get(from).x()
                                + (way.get(to).x() - way.get(from).x()) * (j - from) / (to - from);
                assertThat(Math.abs(straight - way.get(j).x())).isLessThanOrEqualTo(1.5);
            }
        }
    }
}
