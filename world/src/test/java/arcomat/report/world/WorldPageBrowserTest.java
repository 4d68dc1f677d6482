package arcomat.report.world;

import static org.assertj.core.api.Assertions.assertThat;

import arcomat.pipeline.Progress;
import arcomat.pipeline.Session;
import arcomat.pipeline.WrongUse;
import arcomat.pipeline.world.PrepareWorld;
import arcomat.pipeline.world.PreparedWorld.Explained;
import arcomat.pipeline.world.WriteReplay;
import arcomat.report.page.BrowserTest;
import arcomat.sim.Laboratory;
import arcomat.sim.device.Limits;
import arcomat.world.Seeds;

import org.junit.jupiter.api.function.Executable;
import org.openqa.selenium.Keys;
import org.openqa.selenium.WebElement;

import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.Optional;

/** The page that plays a world again, in a browser: play, pause, speed, follow, step. */
class WorldPageBrowserTest extends BrowserTest {
    private static final String WORLD = "models/coffee/world/meeting.world";

    @Override
    protected Map<String, Executable> tests() {
        return Map.of("the meeting is played again", this::play);
    }

    private void play() throws WrongUse {
        Session session = Session.in(Path.of(""), Progress.NONE);
        Explained run =
                session.run(new PrepareWorld(WORLD, false))
                        .explain(Seeds.of(1), Laboratory.PATIENCE, Limits.OF_THE_BRICK);
        session.run(
                new WriteReplay(
                        run.recording(),
                        run.inside(),
                        Optional.empty(),
                        "the meeting",
                        folder.toString()));
        String page = folder.resolve("index.html").toUri().toString();
        browser.open(page, ".floor .robot");
        stepsAndJumps();
        tellsWhyNot();
        plays();
        follows();
        goesInside();
        namesAreApart();
        browser.open(page + "?again#7", ".floor .robot");
        assertThat(browser.text("#clock")).startsWith("7.0 s");
        assertThat(browser.find("#moment").getDomAttribute("aria-valuetext"))
                .as("for who does not see it")
                .isEqualTo("7.0 s of 22.0 s: empty backing");
        isPrinted();
        keepsItsAddress(page);
        browser.wear("dark");
        browser.picture("world-dark");
        browser.wear("light");
        aGhostIsShown(session, run);
    }

    /** Of each row that is no curve, how many boxes of values there are more than texts. */
    private static final String WORDLESS_BOXES =
            """
            const rows = [...document.querySelectorAll(".piece .row")];
            const count = (lane) => [...lane.querySelectorAll("path.run")].reduce((sum, path) => sum + path.getAttribute("d").split("M").length - 1, lane.querySelectorAll("rect.run").length);
            return rows.flatMap((row, index) => {
              const lane = row.querySelector(".lane");
              if (lane === null || lane.querySelector(".curve, .band") !== null) {
                return [];
              }
              const below = rows[index + 1]?.querySelectorAll(".told span") ?? [];
              const missing = count(lane) - lane.querySelectorAll("text").length - below.length;
              return missing === 0 ? [] : [row.querySelector(".name").textContent + ": " + missing];
            });
            """;

    /** Paper says which moment it shows, what each message is, and has nothing to be pressed. */
    private void isPrinted() {
        browser.run("window.dispatchEvent(new Event('beforeprint'))");
        browser.print();
        assertThat(browser.findAll(".piece .lane path.run")).as("short ones").isNotEmpty();
        assertThat(browser.findAll(".piece .told span")).isNotEmpty();
        assertThat((List<?>) browser.run(WORDLESS_BOXES)).isEmpty();
        assertThat(browser.find("#clock").isDisplayed()).isTrue();
        assertThat(browser.findAll("#player button, #player input, .card button"))
                .isNotEmpty()
                .noneMatch(WebElement::isDisplayed);
        browser.picture("world-printed");
        browser.wear("light");
    }

    /** Who opens the address sees the same: second, robot, row, folds. */
    private void keepsItsAddress(String page) {
        browser.findAll("#inside .choices button").get(1).click();
        browser.find("#inside .group-box .group").click();
        browser.find("#inside .group-box:not(.folded) .track .name").click();
        String folded = browser.find("#inside .group-box.folded").getDomAttribute("data-name");
        String row = browser.find("#inside .track.selected .name").getDomAttribute("title");
        browser.await(() -> hash().matches("#7/[^/]+/loaded/" + folded));
        browser.open(page + "?kept" + hash(), "#inside .track.selected .name");
        assertThat(browser.text("#clock")).startsWith("7.0 s");
        assertThat(browser.find("#inside .choices [aria-pressed='true']").getText())
                .isEqualTo("loaded");
        assertThat(browser.findAll("#inside .group-box.folded")).hasSize(1);
        assertThat(browser.find("#inside .track.selected .name").getDomAttribute("title"))
                .isEqualTo(row);
    }

    private String hash() {
        return (String) browser.run("return location.hash");
    }

    /** Of the robot that was chosen, at the moment of the floor; and the floor comes along. */
    private void goesInside() {
        assertThat(browser.findAll("#inside .choices button"))
                .extracting(WebElement::getText)
                .containsExactly("empty", "loaded");
        browser.press(Keys.HOME);
        browser.findAll("#inside .choices button").get(1).click();
        assertThat(browser.findAll("#inside .connector.live")).isNotEmpty();
        assertThat(browser.findAll("#inside .drawing .state.active")).hasSizeGreaterThan(5);
        browser.pressWithShift(Keys.ARROW_RIGHT);
        browser.pressWithShift(Keys.ARROW_RIGHT);
        assertThat(displays()).containsExactly("driving", "waiting");
        assertThat(browser.findAll("#inside .drawing .state.active text"))
                .extracting(WebElement::getText)
                .contains("waiting");
        String clock = browser.text("#clock");
        browser.find("#inside .track .lane").click();
        assertThat(browser.text("#clock")).isNotEqualTo(clock);
        browser.picture("world-inside");
    }

    private static final String WHEN_NAMES_MEET =
            """
            const slider = document.getElementById("moment");
            for (let time = 0; time <= 22000; time += 250) {
              slider.value = time;
              slider.dispatchEvent(new Event("input"));
              const [one, other] = [...document.querySelectorAll(".floor > text")].map((each) => each.getBoundingClientRect());
              if (one.left < other.right && other.left < one.right && one.top < other.bottom && other.top < one.bottom) {
                return time;
              }
            }
            return -1;
            """;

    private void namesAreApart() {
        assertThat(browser.run(WHEN_NAMES_MEET)).as("milliseconds").isEqualTo(-1L);
    }

    private void aGhostIsShown(Session session, Explained run) throws WrongUse {
        Ghost same = Ghost.read(WorldJson.render(run.recording()), "before").orElseThrow();
        List<List<Double>> first = same.frames().get(0);
        List<List<List<Double>>> standing = same.frames().stream().map(each -> first).toList();
        Ghost other = new Ghost("standing", same.period(), same.robots(), standing);
        for (Ghost each : List.of(same, other)) {
            session.run(
                    new WriteReplay(
                            run.recording(),
                            List.of(),
                            Optional.of(each),
                            "the meeting",
                            folder.toString()));
            String page = folder.resolve("index.html").toUri() + "?" + each.label() + "#7";
            browser.open(page, ".floor .ghost");
            assertThat(browser.findAll(".floor .ghost")).hasSize(2);
            assertThat(browser.find("#inside").isDisplayed()).as("without models").isFalse();
            assertThat(browser.text(".ghost-note"))
                    .matches(
                            each == same
                                    ? "dashed: before, seed 1; all go the same way"
                                    : "dashed: standing; they part at 0\\.\\d s");
        }
        browser.picture("world-ghost");
    }

    private void stepsAndJumps() {
        assertThat(browser.text("#clock")).startsWith("0.0 s of 22.0 s");
        browser.press(Keys.ARROW_RIGHT, Keys.ARROW_RIGHT);
        assertThat(browser.text("#clock")).startsWith("0.2 s");
        browser.pressWithShift(Keys.ARROW_RIGHT);
        assertThat(browser.text("#events .current")).contains("loaded waiting");
        assertThat(displays()).containsExactly("driving", "waiting");
        browser.press(Keys.END);
        assertThat(browser.text("#clock")).startsWith("22.0 s");
        WebElement backing =
                browser.findAll("#events button").stream()
                        .filter(event -> event.getText().contains("empty backing"))
                        .findFirst()
                        .orElseThrow();
        backing.click();
        assertThat(displays()).containsExactly("backing", "waiting");
        String clock = browser.text("#clock");
        browser.press(Keys.ARROW_RIGHT);
        assertThat(browser.text("#clock")).as("keys work after a click").isNotEqualTo(clock);
        browser.press(Keys.ARROW_LEFT);
        assertThat(browser.findAll(".floor .ray")).hasSize(2);
        browser.picture("world");
    }

    /** Most parts of a program wait for something, most of the time. */
    private void tellsWhyNot() {
        browser.findAll(".card .idle summary").get(0).click();
        assertThat(browser.text(".card .idle"))
                .containsPattern("avoidCrash: \\w+ -> \\w+ \\(line \\d+\\) did not fire: ");
        browser.picture("world-why-not");
    }

    private List<String> displays() {
        return browser.findAll(".card .display").stream().map(WebElement::getText).toList();
    }

    private void plays() {
        browser.run("document.activeElement.blur()");
        browser.press(Keys.HOME, "-", Keys.SPACE);
        browser.await(() -> browser.text("#play").equals("Pause"));
        browser.await(() -> seconds() > 2);
        browser.press(Keys.SPACE);
        browser.await(() -> browser.text("#play").equals("Play"));
        double stopped = seconds();
        browser.run(
                "return new Promise((done) => requestAnimationFrame(() =>"
                        + " requestAnimationFrame(done)))");
        assertThat(seconds()).isEqualTo(stopped);
        assertThat(browser.find("#speed").getDomProperty("value")).isEqualTo("0.5");
    }

    private double seconds() {
        return Double.parseDouble(browser.text("#clock").split(" ")[0]);
    }

    /** The floor around the robot, instead of all of it. */
    private void follows() {
        String all = browser.find(".floor").getDomAttribute("viewBox");
        WebElement follow = browser.find(".card button");
        follow.click();
        assertThat(browser.find(".floor").getDomAttribute("viewBox")).isNotEqualTo(all);
        assertThat(follow.getDomAttribute("aria-pressed")).isEqualTo("true");
        browser.press(Keys.END);
        assertThat(browser.text("#clock")).as("keys work after a click").startsWith("22.0 s");
        follow.click();
        assertThat(browser.find(".floor").getDomAttribute("viewBox")).isEqualTo(all);
    }
}
