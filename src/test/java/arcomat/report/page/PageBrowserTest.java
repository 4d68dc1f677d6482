package arcomat.report.page;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.function.Executable;
import org.openqa.selenium.Keys;
import org.openqa.selenium.WebElement;

import java.io.IOException;
import java.net.URLEncoder;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.time.Instant;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;

/** Pages in a browser: they open, step, jump and find, and run nothing that a model wrote. */
class PageBrowserTest extends BrowserTest {
    @Override
    protected Map<String, Executable> tests() {
        Map<String, Executable> tests = new LinkedHashMap<>();
        tests.put("keys step and jump", this::keysStepAndJump);
        tests.put("what is written is found", this::whatIsWrittenIsFound);
        tests.put("the picture follows", this::thePictureFollows);
        tests.put("wires say what they carry", this::wiresSayWhatTheyCarry);
        tests.put("parts are folded", this::partsAreFolded);
        tests.put(
                "closed parts take their messages along", this::closedPartsTakeTheirMessagesAlong);
        tests.put("rows are put in order by hand", this::rowsArePutInOrder);
        tests.put("the address keeps what is arranged", this::theAddressKeepsWhatIsArranged);
        tests.put("addresses of others do no harm", this::addressesOfOthersDoNoHarm);
        tests.put("a run is played", this::aRunIsPlayed);
        tests.put("keys work after clicks", this::keysWorkAfterClicks);
        tests.put("hostile texts stay texts", this::hostileTextsStayTexts);
        tests.put("texts can be selected", this::textsCanBeSelected);
        tests.put("100,000 slices", this::longRuns);
        tests.put("the address says what is shown", this::theAddressSaysWhatIsShown);
        tests.put("all of a run is printed", this::allOfARunIsPrinted);
        return tests;
    }

    private void open(Page page) throws IOException {
        Path file = folder.resolve("index.html");
        Files.writeString(file, PageText.render(page));
        browser.open(file);
    }

    private void keysStepAndJump() throws IOException {
        open(SamplePages.small());
        assertThat(step()).as("begins where it fails").isEqualTo("7");
        assertThat(browser.text(".flaw-text")).isEqualTo("fwd is missing");
        browser.press(Keys.ARROW_RIGHT);
        assertThat(step()).isEqualTo("8");
        browser.press(Keys.ARROW_LEFT, Keys.ARROW_LEFT);
        assertThat(step()).isEqualTo("6");
        browser.pressWithShift(Keys.ARROW_LEFT);
        assertThat(step()).as("the state changes").isEqualTo("5");
        browser.press(Keys.END);
        assertThat(step()).isEqualTo("9");
        browser.press(Keys.ARROW_RIGHT);
        assertThat(step()).as("there is no further one").isEqualTo("9");
        browser.press(Keys.HOME);
        assertThat(step()).isEqualTo("0");
        browser.press(Keys.ARROW_DOWN, Keys.ARROW_DOWN);
        assertThat(browser.text(".track.selected .name")).isEqualTo("state");
        browser.pressWithShift(Keys.ARROW_RIGHT);
        assertThat(step()).as("changes of the chosen row only").isEqualTo("5");
        browser.press("f");
        assertThat(step()).isEqualTo("7");
        browser.press("?");
        assertThat(browser.find("#help").isDisplayed()).isTrue();
        browser.press(Keys.ESCAPE);
        assertThat(browser.find("#help").isDisplayed()).isFalse();
        browser.find("#step").clear();
        browser.find("#step").sendKeys("3", Keys.ENTER);
        assertThat(step()).isEqualTo("3");
        browser.find(".remarks button").click();
        assertThat(step()).isEqualTo("7");
    }

    private void whatIsWrittenIsFound() throws IOException {
        open(SamplePages.small());
        browser.press("/");
        browser.press("CMD = fwd", Keys.ENTER);
        assertThat(step()).as("the first one behind the cursor").isEqualTo("9");
        browser.press(Keys.ENTER);
        assertThat(step()).as("round").isEqualTo("0");
        assertThat(browser.text(".count")).isEqualTo("1 of 4");
        browser.press(Keys.chord(Keys.CONTROL, "a"), "nowhere");
        browser.await(() -> browser.text(".count").equals("none"));
        browser.press(Keys.ESCAPE, "n");
        assertThat(step()).isEqualTo("0");
        browser.press("/");
        browser.press("backing", Keys.ENTER);
        assertThat(step()).isEqualTo("5");
    }

    private void theAddressSaysWhatIsShown() throws IOException {
        open(SamplePages.small());
        String page = folder.resolve("index.html").toUri().toString();
        browser.press(Keys.ARROW_DOWN, Keys.ARROW_RIGHT);
        browser.await(() -> address().endsWith("#8/cmd"));
        browser.press(Keys.ESCAPE);
        browser.await(() -> address().endsWith("#8"));
        browser.open(page + "?again#3/state", "#story > *");
        assertThat(step()).isEqualTo("3");
        assertThat(browser.text(".track.selected .name")).isEqualTo("state");
        browser.run("location.hash = '#5'");
        browser.await(() -> step().equals("5"));
        browser.open(page + "?third#99999/nobody/%", "#story > *");
        assertThat(step()).as("what there is none of").isEqualTo("9");

        open(SamplePages.hostile());
        String hostile = SamplePages.HOSTILE.get(3);
        browser.press(Keys.HOME, "]", "]", "]");
        browser.press(Keys.ARROW_RIGHT);
        String encoded = URLEncoder.encode(hostile, StandardCharsets.UTF_8).replace("%27", "'");
        browser.await(() -> address().endsWith("#2//" + encoded));
        browser.open(page + "?fourth#" + address().split("#")[1], "#story > *");
        assertThat(browser.text("#story h2")).isEqualTo(hostile);
        assertThat(step()).isEqualTo("2");
    }

    /** Of a part that is closed, only what it sends itself is said. */
    private void closedPartsTakeTheirMessagesAlong() throws IOException {
        open(SamplePages.nestedParts());
        browser.press(Keys.ARROW_RIGHT);
        browser.find("[data-do=fold]").click();
        assertThat(browser.find(".carried[data-beside='a.b.o']").isDisplayed()).isFalse();
        assertThat(browser.text(".carried[data-beside='a.o']")).isEqualTo("x");
        assertThat(left(".carried[data-beside='a.o']"))
                .isEqualTo(left("[data-port='a.o'] rect") + 10)
                .isLessThan(90);
        browser.find("[data-do=fold]").click();
        assertThat(left("[data-port='a.o'] rect")).isEqualTo(297);
        assertThat(left(".carried[data-beside='a.o']")).isEqualTo(307);
    }

    private double left(String selector) {
        return Double.parseDouble(browser.find(selector).getDomAttribute("x"));
    }

    private String address() {
        return (String) browser.run("return location.href");
    }

    /** What a printer is given: the pieces are drawn when somebody prints. */
    private void allOfARunIsPrinted() throws IOException {
        open(SamplePages.large(45, 3));
        browser.run("window.dispatchEvent(new Event('beforeprint'))");
        browser.print();
        assertThat(browser.find("#timeline").isDisplayed()).isFalse();
        assertThat(browser.findAll(".piece")).hasSize(4).allMatch(WebElement::isDisplayed);
        assertThat(browser.text(".piece:first-child .ruler")).contains("0", "10");
        assertThat(browser.text(".piece:last-child .ruler")).contains("44").doesNotContain("46");
        assertThat(browser.run("return document.querySelector('.rows').textContent"))
                .as("on the screen there is no room")
                .asString()
                .contains("…");
        assertThat(browser.findAll(".piece .lane text"))
                .isNotEmpty()
                .noneMatch(each -> each.getText().contains("…"));
        assertThat(browser.findAll(".piece:last-child .lane *")).isNotEmpty();
        browser.picture("printed");

        open(SamplePages.large(5000, 3));
        browser.run("location.hash = '#4999'");
        browser.await(() -> step().equals("4999"));
        browser.run("window.dispatchEvent(new Event('beforeprint'))");
        browser.print();
        assertThat(browser.text(".paper-run p"))
                .isEqualTo("slice 4600 to 4999 of 0–4999, around 4999");
        assertThat(browser.findAll(".piece")).hasSize(29);
    }

    private void thePictureFollows() throws IOException {
        open(SamplePages.small());
        assertThat(active()).containsExactly("1");
        browser.press(Keys.HOME);
        assertThat(active()).containsExactly("0");
    }

    private void wiresSayWhatTheyCarry() throws IOException {
        open(SamplePages.parts());
        assertThat(browser.findAll(".connector.live")).isEmpty();
        browser.press(Keys.ARROW_RIGHT);
        assertThat(browser.findAll(".connector.live")).hasSize(1);
        assertThat(browser.text(".carried")).isEqualTo("x");
        browser.press(Keys.ARROW_RIGHT);
        assertThat(browser.findAll(".connector.live")).isEmpty();
        assertThat(browser.text(".carried")).isEmpty();
    }

    /** Names of rows as they are seen, from above to below. */
    private List<String> rows() {
        return browser.findAll(".track .name").stream()
                .filter(WebElement::isDisplayed)
                .map(WebElement::getText)
                .toList();
    }

    private void partsAreFolded() throws IOException {
        open(SamplePages.parts());
        assertThat(rows()).containsExactly("i", "j", "o", "state", "o", "o");
        browser.findAll("button.group").get(1).click();
        assertThat(rows()).as("of a part, what it sends").containsExactly("i", "j", "o", "o");
        assertThat(browser.findAll("button.group").get(1).getDomAttribute("aria-expanded"))
                .isEqualTo("false");
        browser.press(Keys.ARROW_DOWN, Keys.ARROW_DOWN, Keys.ARROW_DOWN, "z");
        assertThat(rows()).as("by a key again").hasSize(6);
        browser.press("Z");
        assertThat(rows()).containsExactly("o", "o");
        browser.run("location.hash = '#1/a.b.o'");
        browser.await(() -> rows().size() == 4);
        assertThat(rows()).as("what is asked for").containsExactly("o", "state", "o", "o");
        browser.picture("folded");
    }

    private void rowsArePutInOrder() throws IOException {
        open(SamplePages.parts());
        browser.press(Keys.ARROW_DOWN, Keys.chord(Keys.ALT, Keys.ARROW_DOWN));
        assertThat(rows()).startsWith("j", "i", "o");
        browser.press(Keys.chord(Keys.ALT, Keys.ARROW_DOWN));
        assertThat(rows()).as("a row stays in its group").startsWith("j", "i", "o");
        browser.drag(".track .grip", 24);
        assertThat(rows()).as("by its grip").startsWith("i", "j", "o");
    }

    private void theAddressKeepsWhatIsArranged() throws IOException {
        open(SamplePages.parts());
        String page = folder.resolve("index.html").toUri().toString();
        browser.press(Keys.ARROW_DOWN, Keys.chord(Keys.ALT, Keys.ARROW_DOWN));
        browser.findAll("button.group").get(1).click();
        List<String> arranged = List.of("j", "i", "o", "o");
        assertThat(rows()).isEqualTo(arranged);
        browser.await(() -> address().endsWith("#0/i//part%20a/inputs,j,i"));
        browser.open(page + "?again#1///part%20a/inputs,j,i", "#story > *");
        assertThat(rows()).isEqualTo(arranged);
        assertThat(step()).isEqualTo("1");
        browser.run("location.hash = '#2'");
        browser.await(() -> step().equals("2"));
        assertThat(rows()).as("what it does not say stays").isEqualTo(arranged);
        browser.run("location.hash = '#2///'");
        browser.await(() -> rows().equals(List.of("i", "j", "o", "state", "o", "o")));
    }

    /** What nobody on the page is called folds nothing, and is no place in an order. */
    private void addressesOfOthersDoNoHarm() throws IOException {
        open(SamplePages.parts());
        String page = folder.resolve("index.html").toUri().toString();
        List<String> hostile =
                List.of(
                        "#1///%,__proto__,constructor,nobody/__proto__,j;nobody,j,i;%E0%A4%A,x;;,",
                        "#1/<img src=x>/%3Cscript%3E/<b>,i,j/<b>,j;outputs,i,j,<i>",
                        "#1///" + "part%20,".repeat(2000) + "/" + "inputs,nobody,;".repeat(2000),
                        "#////////");
        for (int i = 0; i < hostile.size(); i++) {
            browser.open(page + "?hostile" + i + hostile.get(i), "#story > *");
            assertThat(rows()).containsExactly("i", "j", "o", "state", "o", "o");
            assertThat(browser.problems()).isEmpty();
        }
        browser.open(page + "?half#1///nobody/inputs,nobody,j,j", "#story > *");
        assertThat(rows()).as("what there is").startsWith("j", "i", "o");
    }

    private void aRunIsPlayed() throws IOException {
        open(SamplePages.parts());
        browser.press(" ");
        assertThat(browser.text("#play")).isEqualTo("Pause");
        browser.await(() -> step().equals("3"));
        browser.await(() -> browser.text("#play").equals("Play"));
        browser.press(" ");
        browser.await(() -> step().equals("1"));
        browser.press(" ");
        assertThat(browser.text("#play")).isEqualTo("Play");
    }

    private void keysWorkAfterClicks() throws IOException {
        open(SamplePages.small());
        browser.find(".remarks button").click();
        browser.press(Keys.HOME);
        assertThat(step()).isEqualTo("0");
        browser.find("button[title='Last (End)']").click();
        browser.press(Keys.ARROW_DOWN, Keys.HOME);
        assertThat(browser.text(".track.selected .name")).isEqualTo("cmd");
        assertThat(step()).isEqualTo("0");
        browser.find("button.group").click();
        browser.press(Keys.END);
        assertThat(step()).isEqualTo("9");
        browser.find("#play").click();
        browser.press(" ");
        assertThat(browser.text("#play")).isEqualTo("Play");
    }

    private List<String> active() {
        return browser.findAll(".drawing .state.active").stream()
                .map(each -> each.getDomAttribute("data-state"))
                .toList();
    }

    private void hostileTextsStayTexts() throws IOException {
        open(SamplePages.hostile());
        for (int story = 0; story < SamplePages.HOSTILE.size(); story++) {
            browser.press(Keys.HOME);
            for (int step = 0; step < SamplePages.HOSTILE.size(); step++) {
                browser.press(Keys.ARROW_RIGHT);
            }
            browser.press("]");
        }
        browser.press("/");
        browser.press("<img", Keys.ENTER);
        assertThat(browser.run("return typeof window.hacked")).isEqualTo("undefined");
        assertThat(browser.findAll("img, script:not([type]) ~ script, svg[onload]")).isEmpty();
        assertThat(browser.text("h1")).isEqualTo(SamplePages.HOSTILE.get(1));
        assertThat(browser.text(".chip")).isEqualTo(SamplePages.HOSTILE.get(0));
        browser.picture("hostile");
    }

    private void textsCanBeSelected() throws IOException {
        open(SamplePages.small());
        browser.run("document.getSelection().selectAllChildren(document.querySelector('.rows'))");
        String selected = (String) browser.run("return String(document.getSelection())");
        assertThat(selected).contains("cmd", "driving");
    }

    private void longRuns() throws IOException {
        int steps = 100_000;
        Page page = SamplePages.large(steps, 20);
        Instant begin = Instant.now();
        open(page);
        browser.press("0");
        browser.await(() -> browser.text(".ruler").contains("90000"));
        browser.press(Keys.END);
        assertThat(step()).isEqualTo("99999");
        browser.press("/");
        browser.press("noise3 = 1", Keys.ENTER);
        browser.await(() -> browser.text(".count").contains(" of "));
        assertThat(Duration.between(begin, Instant.now())).isLessThan(Duration.ofSeconds(60));
        browser.picture("long");
        assertThat(drawn()).as("only what is to be seen is drawn").isLessThan(20_000);
        assertThat(((Number) browser.run(TIME_OF_A_STEP)).doubleValue())
                .as("milliseconds that a step takes")
                .isLessThan(500);
    }

    /** Milliseconds of a step to the next slice, drawing included, where the whole run is shown. */
    private static final String TIME_OF_A_STEP =
            """
            const button = document.querySelector("button[title='Step back (Left)']");
            const steps = 10;
            const begin = performance.now();
            return new Promise((done) => {
              const step = (left) => {
                button.click();
                const next = left > 0 ? () => step(left - 1) : () => done((performance.now() - begin) / steps);
                requestAnimationFrame(() => requestAnimationFrame(next));
              };
              step(steps);
            });
            """;

    private long drawn() {
        return (Long) browser.run("return document.querySelectorAll('.lane *').length");
    }
}
