package arcomat.live;

import static org.assertj.core.api.Assertions.assertThat;

import arcomat.report.page.BrowserTest;
import arcomat.report.text.Json;

import org.junit.jupiter.api.function.Executable;
import org.openqa.selenium.Keys;

import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.concurrent.locks.LockSupport;
import java.util.stream.Collectors;
import java.util.zip.GZIPOutputStream;

/** The page under the hands of somebody who has a keyboard only. */
class LivePageTest extends BrowserTest {
    /** How the tab that is shown looks. */
    private static final String CHOSEN =
            "return getComputedStyle(document.querySelector('[role=tab][aria-selected=true]'))"
                    + ".backgroundColor";

    /** How many lines of wires are neither upright nor level. */
    private static final String SLANTED =
            """
            return [...document.querySelectorAll('#see [data-connector] path')].filter((path) => {
                const numbers = path.getAttribute('d').match(/-?[\\d.]+/g).map(Number);
                for (let i = 2; i + 1 < numbers.length; i += 2) {
                    const across = Math.abs(numbers[i] - numbers[i - 2]);
                    const down = Math.abs(numbers[i + 1] - numbers[i - 1]);
                    if (Math.min(across, down) > 8) return true;
                }
                return false;
            }).length;
            """;

    /** Whether what stands beside ports can still be read, though the picture is wide. */
    private static final String SMALLEST_LETTERS =
            "return document.querySelector('#see text.small').getBoundingClientRect().height > 6";

    private static final int MOST_BYTES = 1_500_000;

    @Override
    protected Map<String, Executable> tests() {
        Map<String, Executable> tests = new LinkedHashMap<>();
        tests.put("small", this::isSmall);
        tests.put("repairs", this::repairs);
        tests.put("error elsewhere", this::drawsBesideErrors);
        tests.put("completes", this::completes);
        tests.put("completes in worlds", this::completesInWorlds);
        tests.put("half a line", this::liesHalfWritten);
        tests.put("wires", this::drawsWiresFromOwnPorts);
        tests.put("steps", this::steps);
        tests.put("proves", this::proves);
        tests.put("floor", this::runsAWorld);
        tests.put("floor changes", this::runsWhatIsWritten);
        tests.put("no floor", this::saysThatThereIsNoWorld);
        tests.put("remembers", this::remembersInItsAddress);
        tests.put("old browser", this::tellsThatABrowserIsTooOld);
        tests.put("phone", this::fitsAPhone);
        tests.put("floor on a phone", this::floorFitsAPhone);
        return tests;
    }

    private void isSmall() throws IOException {
        ByteArrayOutputStream packed = new ByteArrayOutputStream();
        try (GZIPOutputStream out = new GZIPOutputStream(packed)) {
            out.write(Files.readAllBytes(LivePage.FILE));
        }
        assertThat(packed.size()).isLessThan(MOST_BYTES);
    }

    private String status() {
        return browser.text("#status");
    }

    /** Types a mistake, and takes the repair that is offered. */
    private void repairs() {
        LivePage.open(browser);
        browser.await(() -> browser.findAll("#see .state").size() == 2);
        browser.press(Keys.chord(Keys.ALT, "1"));
        browser.press(Keys.chord(Keys.CONTROL, Keys.HOME));
        browser.run(
                "const v = page.editor.view, at = v.state.doc.toString().indexOf('initial closed')"
                        + " + 12;v.dispatch({selection: {anchor: at}});");
        browser.type("x");
        browser.await(() -> status().startsWith("1 error"));
        assertThat(browser.text("#findings")).contains("ARC0304").contains("Change to 'closed'");
        assertThat(browser.find("#stale").isDisplayed()).isTrue();
        browser.press(Keys.chord(Keys.CONTROL, "."));
        browser.await(() -> status().startsWith("0 errors"));
        browser.picture("live-see-light");
        browser.wear("dark");
        browser.picture("live-see-dark");
    }

    /** What has errors stays as it was, and says so; what has none is drawn anew. */
    private void drawsBesideErrors() {
        LivePage.open(browser);
        browser.await(() -> browser.findAll("#see .state").size() == 2);
        replaceText("initial closed", "initial clsed");
        browser.await(() -> status().startsWith("1 error"));
        assertThat(browser.text("#stale")).startsWith("Door has errors");
        assertThat(browser.findAll("#see .state")).hasSize(2);
        browser.picture("live-old-light");
        choose("Gate");
        browser.await(() -> browser.text("#see").contains("Gate"));
        replaceText("state closed, opened", "state closed, opened, ajar");
        browser.await(() -> browser.findAll("#see .state").size() == 3);
        assertThat(status()).startsWith("1 error");
        assertThat(browser.find("#stale").isDisplayed()).isFalse();
        choose("Door");
        browser.await(() -> browser.text("#see").contains("nothing to see"));
        replaceText("initial clsed", "initial closed");
        browser.await(() -> browser.findAll("#see .state").size() == 2);
        assertThat(browser.find("#stale").isDisplayed()).isFalse();
    }

    private void choose(String component) {
        browser.run(
                "const c = document.getElementById('component'); c.value = '%s';"
                                .formatted(component)
                        + "c.dispatchEvent(new Event('change'));");
    }

    /** In the text that is open. */
    private void replaceText(String words, String others) {
        browser.run(
                "const from = page.editor.view.state.doc.toString().indexOf('%1$s');page.editor.view.dispatch({changes: {from, to: from + '%1$s'.length, insert: '%2$s'}});"
                        .formatted(words, others));
    }

    /** Puts the cursor behind the words. */
    private void goBehind(String words) {
        browser.run(
                "const at = page.editor.view.state.doc.toString().indexOf('%1$s') + '%1$s'.length;"
                                .formatted(words)
                        + "page.editor.view.dispatch({selection: {anchor: at}});");
    }

    /**
     * Words that fit are offered while one types, and by a key; another key tells what they mean.
     */
    private void completes() {
        LivePage.open(browser);
        browser.press(Keys.chord(Keys.ALT, "1"));
        goBehind("initial closed;");
        browser.press(Keys.ENTER);
        browser.type("ope");
        browser.await(() -> offered().contains("opened"));
        assertThat(offered()).contains("state").doesNotContain("button");
        browser.picture("live-completion-light");
        LockSupport.parkNanos(
                Duration.ofMillis(200).toNanos()); // keys at once are not meant for it
        browser.press(Keys.ENTER);
        browser.await(() -> browser.text(".cm-activeLine").strip().equals("opened"));
        browser.type(" -> ");
        browser.press(Keys.chord(Keys.CONTROL, Keys.SPACE));
        browser.await(() -> offered().contains("closed"));
        browser.press(Keys.ESCAPE);
        browser.await(() -> browser.findAll(".cm-tooltip-autocomplete").isEmpty());
        goBehind("initial clos");
        browser.press(Keys.chord(Keys.CONTROL, "i"));
        browser.await(() -> !browser.findAll(".facts").isEmpty());
        assertThat(browser.text(".facts")).contains("state closed");
        browser.picture("live-facts-light");
    }

    /** There, kinds of robots are names. */
    private void completesInWorlds() {
        String world = "floor 900 900\n\nkind rover\n  wheels A B\n\nrobot one \n";
        String state =
                Json.compact(
                        Map.of("files", texts(Map.of("room.world", world)), "needed", List.of()));
        browser.open("about:blank", "html");
        browser.open(LivePage.FILE.toUri() + "#" + LivePage.packed(state), "body[data-checked]");
        browser.press(Keys.chord(Keys.ALT, "1"));
        goBehind("robot one ");
        browser.type("ro");
        browser.await(() -> offered().contains("kind of robots"));
        assertThat(offered()).contains("rover").doesNotContain("wheels");
        browser.picture("live-completion-world-light");
    }

    private String offered() {
        return browser.findAll(".cm-tooltip-autocomplete").stream()
                .map(each -> each.getText())
                .collect(Collectors.joining());
    }

    /** A line that is not finished is a finding, and nothing else stops. */
    private void liesHalfWritten() {
        LivePage.open(browser);
        browser.press(Keys.chord(Keys.ALT, "1"));
        goBehind("{open = true};");
        browser.type("\n op");
        browser.await(() -> status().startsWith("1 error"));
        assertThat(browser.text("#findings")).contains("ARC0001");
    }

    /** Each wire from a port of the whole begins where that port is. */
    private void drawsWiresFromOwnPorts() {
        String state =
                Json.compact(
                        Map.of(
                                "files",
                                List.of(Map.of("path", "Chain.arc", "text", ChainModel.TEXT))));
        browser.open("about:blank", "html");
        browser.open(LivePage.FILE.toUri() + "#" + LivePage.packed(state), "body[data-drawn]");
        assertThat(browser.findAll("#see [data-connector]")).hasSize(23);
        assertThat(browser.run(SLANTED)).isEqualTo(0L);
        browser.run(
                "document.querySelector('#see [data-connector=\"button -> cell3.own\"]')"
                        + ".dispatchEvent(new MouseEvent('mouseover', {bubbles: true}))");
        assertThat(browser.findAll("#see .connector.lit")).hasSize(12);
        assertThat(browser.run(SMALLEST_LETTERS)).isEqualTo(true);
        browser.picture("live-wires-light");
    }

    private void steps() {
        LivePage.open(browser);
        browser.await(() -> browser.findAll("#see .state").size() == 2);
        browser.press(Keys.chord(Keys.ALT, "3"));
        browser.await(() -> !browser.findAll("#run fieldset").isEmpty());
        Object chosen = browser.run(CHOSEN);
        browser.find("[role=tab][aria-selected=true]").click();
        assertThat(browser.run(CHOSEN)).as("under the pointer").isEqualTo(chosen);
        browser.find("#run input[value=true]").click();
        browser.find("#run [type=submit]").sendKeys(Keys.ENTER);
        browser.await(() -> browser.findAll("#run tbody tr").size() == 1);
        assertThat(browser.text("#run tbody tr")).contains("open = true").contains("opened");
        browser.await(() -> browser.text("#run .state.now").equals("opened"));
        browser.picture("live-run-light");
        browser.find("#run [type=submit]").sendKeys(Keys.chord(Keys.ALT, Keys.BACK_SPACE));
        browser.await(() -> browser.findAll("#run tbody tr").isEmpty());
        browser.find("#run [type=submit]").sendKeys(Keys.ENTER);
        browser.await(() -> browser.findAll("#run tbody tr").size() == 1);
        browser.run(
                "[...document.querySelectorAll('#run button')].find(b =>"
                        + " b.textContent.startsWith('Record')).focus()");
        browser.press(Keys.ENTER);
        browser.await(() -> browser.text("#files").contains("DoorRecorded.mt"));
        browser.await(() -> status().startsWith("0 errors"));
    }

    private void proves() {
        LivePage.open(browser);
        browser.await(() -> browser.findAll("#see .state").size() == 2);
        browser.press(Keys.chord(Keys.ALT, "4"));
        browser.run(
                "document.getElementById('prove-left').value ="
                        + " 'Gate';document.getElementById('prove-right').value ="
                        + " 'Door';[...document.querySelectorAll('#prove button')].find(b =>"
                        + " b.textContent === 'Prove').focus()");
        browser.press(Keys.ENTER);
        browser.await(() -> !browser.findAll("#prove details").isEmpty());
        assertThat(browser.text("#prove summary"))
                .isEqualTo("fails: Gate does not refine Door (behaviour)");
        browser.await(() -> browser.findAll("#prove figure").size() == 2);
        assertThat(browser.findAll("#prove figure.stuck")).hasSize(1);
        browser.find("#prove input[type=range]").sendKeys(Keys.LEFT);
        assertThat(browser.text("#prove .moment"))
                .isEqualTo(
                        "step 1: button = true; out: open = true; left is opened; right is opened");
        assertThat(browser.findAll("#prove .state.now")).hasSize(2);
        browser.picture("live-prove-light");
    }

    /** The meeting of two couriers, with the library around it. */
    private void openMeeting() throws IOException {
        String state =
                Json.compact(
                        Map.of(
                                "files",
                                texts(ModelTexts.below(Path.of("../models/coffee"))),
                                "needed",
                                texts(ModelTexts.library())));
        browser.open("about:blank", "html");
        browser.open(LivePage.FILE.toUri() + "#" + LivePage.packed(state), "body[data-checked]");
    }

    private static List<Map<String, String>> texts(Map<String, String> all) {
        return all.entrySet().stream()
                .map(each -> Map.of("path", each.getKey(), "text", each.getValue()))
                .toList();
    }

    private void run() {
        browser.run("delete document.body.dataset.floor");
        browser.find("#floor-seed").sendKeys(Keys.ENTER);
        browser.await(() -> !browser.findAll("body[data-floor]").isEmpty());
    }

    private String clock() {
        return browser.text("#floor #clock");
    }

    private void runsAWorld() throws IOException {
        openMeeting();
        browser.press(Keys.chord(Keys.ALT, "5"));
        assertThat(browser.find("#floor").isDisplayed()).isTrue();
        run();
        assertThat(browser.text("#floor [role=status]"))
                .isEqualTo("22.0 s, no collision (as arcomat world --no-limits --seed 1)");
        assertThat(browser.findAll("#floor svg.floor .robot")).hasSize(2);
        assertThat(browser.text("#floor #events")).contains("loaded driving");
        assertThat(browser.find("#floor .collision").isDisplayed()).isFalse();
        browser.run("document.querySelector('#floor .replay').focus()");
        browser.press(Keys.ARROW_RIGHT);
        assertThat(clock()).isEqualTo("0.1 s of 22.0 s");
        browser.press(Keys.chord(Keys.SHIFT, Keys.ARROW_RIGHT));
        browser.press(Keys.chord(Keys.SHIFT, Keys.ARROW_RIGHT));
        assertThat(clock()).doesNotStartWith("0.1 s");
        browser.press("+");
        browser.press(" ");
        browser.await(() -> clock().startsWith("5."));
        browser.press(" ");
        browser.picture("live-floor-light");
        browser.wear("dark");
        browser.picture("live-floor-dark");
    }

    /** Another text of a model, and of the world: what runs next is that. */
    private void runsWhatIsWritten() throws IOException {
        openMeeting();
        browser.press(Keys.chord(Keys.ALT, "5"));
        run();
        browser.run(
                "const world = page.files.find((each) => each.path ==="
                        + " 'world/meeting.world');world.text = world.text.replace('seconds 22',"
                        + " 'seconds 5');const avoid = page.files.find((each) => each.path ==="
                        + " 'coffee/floor/AvoidCrash.arc');avoid.text ="
                        + " avoid.text.replaceAll('\"driving\"', '\"rolling\"');page.check()");
        browser.await(() -> browser.find("#floor .stale").isDisplayed());
        run();
        assertThat(browser.text("#floor [role=status]")).startsWith("5.0 s");
        assertThat(browser.text("#floor #events")).contains("rolling").doesNotContain("driving");
        assertThat(browser.find("#floor .stale").isDisplayed()).isFalse();
    }

    private void saysThatThereIsNoWorld() {
        LivePage.open(browser);
        browser.press(Keys.chord(Keys.ALT, "5"));
        assertThat(browser.text("#floor [role=status]")).startsWith("There is no world");
        assertThat(browser.find("#floor form").isDisplayed()).isFalse();
    }

    private void floorFitsAPhone() throws IOException {
        browser.resize(390, 844);
        openMeeting();
        browser.press(Keys.chord(Keys.ALT, "5"));
        run();
        assertThat(browser.run("return document.documentElement.scrollWidth <= 390"))
                .isEqualTo(true);
        browser.picture("live-floor-phone-light");
    }

    private void remembersInItsAddress() {
        LivePage.open(browser);
        browser.press(Keys.chord(Keys.ALT, "1"));
        browser.press(Keys.chord(Keys.CONTROL, Keys.HOME));
        browser.type("// mine\n");
        browser.await(() -> browser.run("return location.hash.length > 100").equals(true));
        browser.await(
                () -> browser.run("return page.files[0].text.startsWith('// mine')").equals(true));
        String before = (String) browser.run("return location.href");
        browser.await(() -> !browser.run("return location.href").equals(""));
        browser.open("about:blank", "html");
        browser.open(String.valueOf(before), "body[data-checked]");
        assertThat(browser.text(".cm-content")).contains("component Door");
    }

    private void tellsThatABrowserIsTooOld() {
        LivePage.open(browser);
        browser.run(
                "const known = codeOf;codeOf = (name) => (name === 'core' ? 'delete"
                        + " WebAssembly.compile;' : '') + known(name);page.desk.stop();"
                        + "page.check()");
        browser.await(() -> status().contains("this browser is too old for the page"));
    }

    private void fitsAPhone() {
        browser.resize(390, 844);
        LivePage.open(browser);
        browser.await(() -> browser.findAll("#see .state").size() == 2);
        assertThat(browser.run("return document.documentElement.scrollWidth <= 390"))
                .isEqualTo(true);
        browser.picture("live-phone-light");
    }
}
