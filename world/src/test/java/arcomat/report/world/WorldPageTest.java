package arcomat.report.world;

import static org.assertj.core.api.Assertions.assertThat;

import arcomat.source.SourceFile;
import arcomat.world.Recording;
import arcomat.world.Recording.Event;
import arcomat.world.Recording.Frame;
import arcomat.world.Recording.Idle;
import arcomat.world.Recording.Reason;
import arcomat.world.Recording.RobotFrame;
import arcomat.world.Seeds;
import arcomat.world.World;
import arcomat.world.World.Cup;
import arcomat.world.WorldParser;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;

import org.junit.jupiter.api.Test;

import java.io.IOException;
import java.util.List;
import java.util.Map;
import java.util.regex.Matcher;
import java.util.regex.Pattern;

/** The page that plays a world again loads nothing, and takes texts of programs for texts. */
class WorldPageTest {
    private static final String NASTY = "</script><b>&amp;";
    private static final Pattern DATA =
            Pattern.compile(
                    "<script type=\"application/json\" id=\"data\">(.*?)</script>", Pattern.DOTALL);

    private static Recording recording() {
        String text =
                "floor 1000 1000\nkind rover\nprogram jar </script>.jar\nlight S2\n"
                        + "robot one rover at 500 500\n";
        World world = WorldParser.parse(new SourceFile("w", text)).world().orElseThrow();
        RobotFrame robot =
                new RobotFrame(
                        world.robots().get(0).pose(), 0, 0, List.of(75), Cup.NONE, NASTY, 0, false);
        return new Recording(
                world,
                Seeds.of(1).then(250, 7),
                List.of(new Frame(0, List.of(robot), List.of(), List.of())),
                List.of(new Event.Showed(0, "one", NASTY)),
                Map.of("one", NASTY),
                List.of(),
                List.of(),
                List.of(
                        new Idle(
                                "one",
                                "pilot",
                                List.of(new Reason(0, NASTY), new Reason(100, "")))));
    }

    @Test
    void textsOfProgramsStayTexts() throws IOException {
        String page = WorldPage.render(recording(), List.of(), NASTY);
        assertThat(page).doesNotContain(NASTY).doesNotContain("<b>");
        Matcher data = DATA.matcher(page);
        assertThat(data.find()).isTrue();
        JsonNode json = new ObjectMapper().readTree(data.group(1));
        assertThat(json.at("/events/0/text").asText()).isEqualTo(NASTY);
        assertThat(json.at("/frames/0/robots/0/7").asText()).isEqualTo(NASTY);
        assertThat(json.at("/failures/one").asText()).isEqualTo(NASTY);
        assertThat(json.at("/world/robots/0/program").asText()).isEqualTo("</script>.jar");
        assertThat(json.at("/idle/texts/0").asText()).isEqualTo(NASTY);
        assertThat(json.at("/idle/parts/0").toString())
                .isEqualTo("{\"robot\":\"one\",\"part\":\"pilot\",\"reasons\":[0,0,100,1]}");
        assertThat(json.get("seed").asLong()).isEqualTo(1);
        assertThat(json.at("/then/0/from").asLong()).as("in milliseconds").isEqualTo(2500);
        assertThat(json.at("/then/0/seed").asLong()).isEqualTo(7);
    }

    @Test
    void nothingIsLoaded() {
        String page = WorldPage.render(recording(), List.of(), "a world");
        assertThat(page)
                .contains("default-src 'none'")
                .doesNotContain(" src=")
                .doesNotContain("@import")
                .doesNotContain("{{");
        assertThat(page.replace("http://www.w3.org/2000/svg", "")).doesNotContain("http:");
    }
}
