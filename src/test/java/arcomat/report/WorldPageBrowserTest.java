package arcomat.report;

import static org.assertj.core.api.Assertions.assertThat;

import arcomat.pipeline.Pipeline;
import arcomat.pipeline.Progress;
import arcomat.pipeline.WrongUse;
import arcomat.report.page.Browser;

import org.junit.jupiter.api.Assumptions;
import org.junit.jupiter.api.DynamicTest;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.TestFactory;
import org.junit.jupiter.api.io.TempDir;
import org.openqa.selenium.Keys;
import org.openqa.selenium.WebElement;

import java.nio.file.Path;
import java.util.List;

/** The page that plays a world again, in a browser: play, pause, speed, follow, step. */
@Tag("slow")
class WorldPageBrowserTest {
    private static final String WORLD = "models/coffee/world/meeting.world";

    @TempDir private Path folder;

    @TestFactory
    List<DynamicTest> replay() {
        return List.of(
                Browser.isThere()
                        ? DynamicTest.dynamicTest("the meeting is played again", this::play)
                        : DynamicTest.dynamicTest(
                                "skipped: there is no 'chromium' with 'chromedriver' here",
                                () -> Assumptions.abort("no browser")));
    }

    private void play() throws WrongUse {
        Pipeline pipeline = new Pipeline(Path.of(""), Progress.NONE);
        pipeline.writeReplay(pipeline.prepareWorld(WORLD).run(1), "the meeting", folder.toString());
        String page = folder.resolve("index.html").toUri().toString();
        try (Browser browser = new Browser()) {
            browser.open(page, ".floor .robot");
            stepsAndJumps(browser);
            plays(browser);
            follows(browser);
            browser.open(page + "?again#7", ".floor .robot");
            assertThat(browser.text("#clock")).startsWith("7.0 s");
            browser.wear("dark");
            browser.picture("world-dark");
            assertThat(browser.problems()).isEmpty();
        }
    }

    private static void stepsAndJumps(Browser browser) {
        assertThat(browser.text("#clock")).startsWith("0.0 s of 22.0 s");
        browser.press(Keys.ARROW_RIGHT, Keys.ARROW_RIGHT);
        assertThat(browser.text("#clock")).startsWith("0.2 s");
        browser.pressWithShift(Keys.ARROW_RIGHT);
        assertThat(browser.text("#events .current")).contains("loaded waiting");
        assertThat(displays(browser)).containsExactly("driving", "waiting");
        browser.press(Keys.END);
        assertThat(browser.text("#clock")).startsWith("22.0 s");
        WebElement backing =
                browser.findAll("#events button").stream()
                        .filter(event -> event.getText().contains("empty backing"))
                        .findFirst()
                        .orElseThrow();
        backing.click();
        assertThat(displays(browser)).containsExactly("backing", "waiting");
        assertThat(browser.findAll(".floor .ray")).hasSize(2);
        browser.picture("world");
    }

    private static List<String> displays(Browser browser) {
        return browser.findAll(".card .display").stream().map(WebElement::getText).toList();
    }

    private static void plays(Browser browser) {
        browser.run("document.activeElement.blur()");
        browser.press(Keys.HOME, "+", "+", "+", "+", Keys.SPACE);
        assertThat(browser.text("#play")).isEqualTo("Pause");
        browser.await(() -> seconds(browser) > 2);
        browser.press(Keys.SPACE);
        assertThat(browser.text("#play")).isEqualTo("Play");
        double stopped = seconds(browser);
        browser.run(
                "return new Promise((done) => requestAnimationFrame(() =>"
                        + " requestAnimationFrame(done)))");
        assertThat(seconds(browser)).isEqualTo(stopped);
        assertThat(browser.find("#speed").getDomProperty("value")).isEqualTo("16");
    }

    private static double seconds(Browser browser) {
        return Double.parseDouble(browser.text("#clock").split(" ")[0]);
    }

    /** The floor around the robot, instead of all of it. */
    private static void follows(Browser browser) {
        String all = browser.find(".floor").getDomAttribute("viewBox");
        WebElement follow = browser.find(".card button");
        follow.click();
        assertThat(browser.find(".floor").getDomAttribute("viewBox")).isNotEqualTo(all);
        assertThat(follow.getDomAttribute("aria-pressed")).isEqualTo("true");
        follow.click();
        assertThat(browser.find(".floor").getDomAttribute("viewBox")).isEqualTo(all);
    }
}
