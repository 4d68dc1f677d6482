package arcomat.report.page;

import static org.assertj.core.api.Assertions.assertThat;

import arcomat.cli.Cli;
import arcomat.cli.terminal.Console;

import org.junit.jupiter.api.function.Executable;
import org.openqa.selenium.Keys;

import java.io.BufferedReader;
import java.io.IOException;
import java.io.PrintWriter;
import java.io.StringReader;
import java.io.Writer;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;

/** What commands write with {@code --report}, in a browser. */
class CommandPagesBrowserTest extends BrowserTest {
    private static final Path COFFEE = Path.of("models/coffee").toAbsolutePath();

    @Override
    protected Map<String, Executable> tests() {
        Map<String, Executable> tests = new LinkedHashMap<>();
        tests.put("strings of models stay texts", this::stringsOfModelsStayTexts);
        tests.put("simulate", this::simulate);
        tests.put("refines", this::refines);
        tests.put("contradictions", this::contradictions);
        tests.put("test", this::streamTests);
        tests.put("run-brick", this::runBrick);
        return tests;
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
                "--models",
                COFFEE.toString(),
                "--report",
                folder.toString());
        browser.open(folder.resolve("index.html"));
        browser.press(Keys.ARROW_RIGHT);
        assertThat(browser.text(".time")).isEqualTo("0.10 s");
        assertThat(browser.text(".rows")).contains("sensor S1", "motor A", "part avoidCrash");
        assertThat(activeStates()).contains("driving");
        browser.open(folder.resolve("index.html").toUri() + "?five#5", "#story > *");
        browser.await(() -> browser.text(".time").equals("0.50 s"));
        assertThat(activeStates()).contains("backing");
        assertThat(browser.findAll(".drawing .connector.live")).isNotEmpty();
        assertThat(browser.findAll(".drawing .carried"))
                .extracting(each -> each.getText())
                .contains("tooClose");
        photograph("run-brick");
    }

    private List<String> activeStates() {
        return browser.findAll(".drawing .state.active text").stream()
                .map(each -> each.getText())
                .toList();
    }

    private void photograph(String name) {
        browser.picture(name + "-light");
        assertThat(Contrast.faintTexts(browser)).isEmpty();
        browser.wear("dark");
        browser.picture(name + "-dark");
        assertThat(Contrast.faintTexts(browser)).isEmpty();
        browser.wear("light");
    }

    private void arcomat(int status, String... words) {
        Console console =
                Console.quiet(
                        folder,
                        new PrintWriter(Writer.nullWriter()),
                        new PrintWriter(System.out),
                        new BufferedReader(new StringReader("")));
        assertThat(Cli.run(words, console)).isEqualTo(status);
    }
}
