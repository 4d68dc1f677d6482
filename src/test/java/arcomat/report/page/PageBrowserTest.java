package arcomat.report.page;

import static org.assertj.core.api.Assertions.assertThat;

import arcomat.cli.Cli;
import arcomat.cli.Console;
import arcomat.report.Style;

import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Assumptions;
import org.junit.jupiter.api.DynamicTest;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.TestFactory;
import org.junit.jupiter.api.function.Executable;
import org.junit.jupiter.api.io.TempDir;
import org.openqa.selenium.Keys;

import java.io.BufferedReader;
import java.io.IOException;
import java.io.PrintWriter;
import java.io.StringReader;
import java.io.Writer;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.time.Instant;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.stream.Stream;

/** Pages in a browser: they open, step, jump and find, and run nothing that a model wrote. */
@Tag("slow")
class PageBrowserTest {
    private static final Path COFFEE = Path.of("models/coffee").toAbsolutePath();

    @TempDir private Path folder;
    private Browser browser;

    @TestFactory
    Stream<DynamicTest> pages() {
        if (!Browser.isThere()) {
            return Stream.of(
                    DynamicTest.dynamicTest(
                            "skipped: there is no 'chromium' with 'chromedriver' on this machine",
                            () -> Assumptions.abort("no browser")));
        }
        browser = new Browser();
        Map<String, Executable> tests = new LinkedHashMap<>();
        tests.put("keys step and jump", this::keysStepAndJump);
        tests.put("what is written is found", this::whatIsWrittenIsFound);
        tests.put("the picture follows", this::thePictureFollows);
        tests.put("hostile texts stay texts", this::hostileTextsStayTexts);
        tests.put("strings of models stay texts", this::stringsOfModelsStayTexts);
        tests.put("texts can be selected", this::textsCanBeSelected);
        tests.put("100,000 slices", this::longRuns);
        tests.put("simulate", this::simulate);
        tests.put("refines", this::refines);
        tests.put("contradictions", this::contradictions);
        tests.put("test", this::streamTests);
        tests.put("run-brick", this::runBrick);
        return tests.entrySet().stream()
                .map(test -> DynamicTest.dynamicTest(test.getKey(), () -> check(test.getValue())));
    }

    private void check(Executable test) throws Throwable {
        browser.wear("light");
        test.execute();
        assertThat(browser.problems()).as("what the console says").isEmpty();
    }

    @AfterEach
    void close() {
        if (browser != null) {
            browser.close();
        }
    }

    private void open(Page page) throws IOException {
        Path file = folder.resolve("index.html");
        Files.writeString(file, PageText.render(page));
        browser.open(file);
    }

    private String step() {
        return browser.find("#step").getDomProperty("value");
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

    private void thePictureFollows() throws IOException {
        open(SamplePages.small());
        assertThat(active()).containsExactly("1");
        browser.press(Keys.HOME);
        assertThat(active()).containsExactly("0");
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

    /** In the timeline, among the values, and in the picture of the automaton. */
    private void stringsOfModelsStayTexts() throws IOException {
        Path models = Files.createDirectories(folder.resolve("strings"));
        Files.writeString(
                models.resolve("Sly.arc"),
                """
                component Sly {
                  timing instant;
                  port out String text;
                  automaton {
                    state s;
                    initial s;
                    s / {text = "</script><img src=x onerror=window.hacked=1>"};
                  }
                }
                """);
        arcomat(0, "simulate", "--main", "Sly", "--report", folder.toString(), models.toString());
        browser.open(folder.resolve("index.html"));
        assertThat(browser.text(".chip")).contains("</script><img src=x onerror=");
        assertThat(browser.text(".drawing")).contains("</script>");
        assertThat(browser.findAll("img")).isEmpty();
        assertThat(browser.run("return typeof window.hacked")).isEqualTo("undefined");
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
        assertThat(Duration.between(begin, Instant.now())).isLessThan(Duration.ofSeconds(15));
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

    private void simulate() {
        arcomat(
                0,
                "simulate",
                "--input",
                COFFEE.resolve("coffee/fetcher/FetcherTest.mt") + "#makesRoomAndReturnsToTheLine",
                "--report",
                folder.toString(),
                COFFEE.toString());
        browser.open(folder.resolve("index.html"));
        browser.press(Keys.ARROW_RIGHT, Keys.ARROW_RIGHT);
        assertThat(browser.findAll(".drawing .state.active")).hasSize(6);
        photograph("simulate");
    }

    private void refines() throws IOException {
        Path models = Files.createDirectories(folder.resolve("changed/changed"));
        String text = Files.readString(COFFEE.resolve("coffee/fig6/AvoidCrash.arc"));
        Files.writeString(
                models.resolve("AvoidCrash.arc"),
                text.replace("package coffee.fig6", "package changed")
                        .replace(" refines coffee.fig5.AvoidCrash", "")
                        .replace("timerSig == alert} / {cmd = stop}", "timerSig == alert}"));
        arcomat(
                1,
                "refines",
                "changed.AvoidCrash",
                "coffee.fig5.AvoidCrash",
                "--report",
                folder.toString(),
                models.getParent().toString(),
                COFFEE.toString());
        browser.open(folder.resolve("index.html"));
        assertThat(step()).isEqualTo("2");
        assertThat(browser.text(".flawed")).contains("not possible");
        assertThat(browser.findAll(".drawing")).hasSize(2);
        assertThat(browser.findAll(".drawing .state.active text").get(0).getText())
                .isEqualTo("remote");
        photograph("refines");
        browser.press(Keys.ARROW_LEFT);
        assertThat(browser.findAll(".drawing .state.active text"))
                .extracting(each -> each.getText())
                .containsExactly("backing", "backing");
        assertThat(browser.findAll(".drawing .arrow.active")).hasSize(2);
    }

    private void contradictions() throws IOException {
        Path models = Files.createDirectories(folder.resolve("rules"));
        Files.writeString(
                models.resolve("Rules.arc"),
                """
                component Rules {
                  port in Boolean near, out Boolean drive;
                  automaton stops { state s; initial s; s {near == true} / {drive = false}; }
                  automaton drives { state d; initial d; d / {drive = true}; }
                }
                """);
        arcomat(1, "contradictions", "Rules", "--report", folder.toString(), models.toString());
        browser.open(folder.resolve("index.html"));
        assertThat(browser.text(".rows")).contains("near", "may be answered", "none complies");
        assertThat(browser.findAll(".drawing .transition.active")).hasSize(2);
        assertThat(browser.findAll(".drawing")).hasSize(2);
        photograph("contradictions");
    }

    private void streamTests() {
        arcomat(0, "test", "--report", folder.toString(), COFFEE.toString());
        browser.open(folder.resolve("index.html"));
        int tests = browser.findAll("#stories button").size();
        assertThat(tests).isGreaterThan(20);
        browser.press("]");
        assertThat(browser.find("#stories button[aria-current=true]").getText())
                .isEqualTo(browser.text("#story h2"));
        photograph("test");
        browser.find("#stories input").sendKeys("waitsWith");
        browser.await(
                () ->
                        browser.findAll("#stories button").stream()
                                        .filter(each -> each.isDisplayed())
                                        .count()
                                == 1);
    }

    private void runBrick() {
        String out = folder.resolve("brick").toString();
        arcomat(
                0,
                "generate",
                "--target",
                "lejos",
                "--main",
                "coffee.fetcher.Fetcher",
                "--out",
                out,
                COFFEE.toString());
        arcomat(
                0,
                "run-brick",
                "--jar",
                out + "/Fetcher.jar",
                "--script",
                COFFEE.resolve("scripts/fetcher.script").toString(),
                "--report",
                folder.toString());
        browser.open(folder.resolve("index.html"));
        browser.press(Keys.ARROW_RIGHT);
        assertThat(browser.text(".time")).isEqualTo("0.10 s");
        photograph("run-brick");
    }

    private void photograph(String name) {
        browser.picture(name + "-light");
        browser.wear("dark");
        browser.picture(name + "-dark");
    }

    private void arcomat(int status, String... words) {
        Console console =
                new Console(
                        folder,
                        new PrintWriter(Writer.nullWriter()),
                        new PrintWriter(System.out),
                        new BufferedReader(new StringReader("")),
                        Style.PLAIN,
                        true);
        assertThat(Cli.run(words, console)).isEqualTo(status);
    }
}
