package arcomat.site;

import static org.assertj.core.api.Assertions.assertThat;

import arcomat.report.page.BrowserTest;

import org.junit.jupiter.api.function.Executable;
import org.openqa.selenium.Keys;

import java.nio.file.Path;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;

/** The site as a stranger meets it. */
class SiteBrowserTest extends BrowserTest {
    private static final Path SITE = Path.of(System.getProperty("site.folder"));

    /** Pages of each kind: welcome, prose, tables, transcripts, models, a finding. */
    private static final List<String> PAGES =
            List.of(
                    "index",
                    "docs/index",
                    "docs/tutorial",
                    "docs/language",
                    "docs/errors",
                    "docs/learn/cheat-sheet",
                    "docs/learn/exercises",
                    "findings/ARC0104");

    /** Texts whose contrast with what is behind them is below 4.5, as WCAG 2 counts it. */
    private static final String PALE =
            """
            const rgb = (text) => text.match(/[\\d.]+/g).map(Number);
            const light = (c) => [0.2126, 0.7152, 0.0722].reduce((sum, part, i) => {
                const s = c[i] / 255;
                return sum + part * (s <= 0.04045 ? s / 12.92 : ((s + 0.055) / 1.055) ** 2.4);
            }, 0);
            const behind = (e) => {
                for (; e; e = e.parentElement) {
                    const c = rgb(getComputedStyle(e).backgroundColor);
                    if (c.length < 4 || c[3] > 0) return c;
                }
                return [255, 255, 255];
            };
            const pale = new Set();
            const texts = document.createTreeWalker(document.body, NodeFilter.SHOW_TEXT);
            while (texts.nextNode()) {
                const e = texts.currentNode.parentElement;
                if (!texts.currentNode.textContent.trim() || !e.checkVisibility()) continue;
                const [a, b] = [light(rgb(getComputedStyle(e).color)), light(behind(e))];
                const contrast = (Math.max(a, b) + 0.05) / (Math.min(a, b) + 0.05);
                if (contrast < 4.5) pale.add(contrast.toFixed(2) + ' ' + e.outerHTML.slice(0, 90));
            }
            return [...pale];
            """;

    @Override
    protected Map<String, Executable> tests() {
        Map<String, Executable> tests = new LinkedHashMap<>();
        tests.put("search", this::finds);
        tests.put("try", this::opensModelsOnTheLivePage);
        tests.put("link", this::goesFromPageToPage);
        tests.put("contrast", this::isReadByLightAndInTheDark);
        tests.put("phone", this::fitsAPhone);
        tests.put("paper", this::fitsOnOneSheet);
        return tests;
    }

    private void open(String page) {
        browser.open(SITE.resolve(page + ".html").toUri().toString(), "body[data-ready]");
    }

    private void search(String words) {
        browser.press("/");
        browser.type(words);
        browser.await(() -> !browser.findAll("#results a").isEmpty());
    }

    private void finds() {
        open("index");
        search("chaos completion");
        assertThat(browser.text("#results")).contains("What a model means");
        browser.press(Keys.ESCAPE);
        assertThat(browser.find("#results").isDisplayed()).isFalse();
        open("docs/tutorial");
        search("arc0104");
        browser.picture("site-search-light");
        browser.press(Keys.ENTER);
        browser.await(() -> browser.text("h1").equals("ARC0104 A port has one sender"));
        open("docs/tutorial");
        search("wishes contradict");
        browser.press(Keys.ARROW_DOWN, Keys.ENTER);
        browser.await(() -> address().endsWith("#5-wishes-that-contradict-each-other"));
        assertThat(browser.find("#results").isDisplayed()).isFalse();
        browser.press("/");
        browser.type("qqzz");
        browser.await(() -> browser.text("#results").contains("No page has this word."));
    }

    private String address() {
        return String.valueOf(browser.run("return location.href"));
    }

    private void opensModelsOnTheLivePage() {
        open("index");
        browser.find(".block.arc .try").click();
        browser.await(() -> !browser.findAll("body[data-checked]").isEmpty());
        assertThat(browser.text(".cm-content")).contains("component AvoidCrash");
        assertThat(browser.text("#findings"))
                .contains("did you mean 'tooClose'?")
                .contains("did you mean 'driving'?");
        open("docs/tutorial");
        browser.run(
                "[...document.querySelectorAll('.block.arc')].filter(b =>"
                        + " b.textContent.includes('component Robot'))[0]"
                        + ".querySelector('.try').click()");
        browser.await(() -> !browser.findAll("body[data-checked]").isEmpty());
        browser.await(() -> !browser.findAll("#see svg").isEmpty());
        assertThat(browser.text("#status")).startsWith("0 errors");
        assertThat(browser.text("#see svg")).contains("wheels");
        browser.picture("site-try-light");
    }

    private void goesFromPageToPage() {
        browser.resize(1440, 900);
        open("index");
        browser.picture("site-home-light");
        browser.find("main a[href='docs/tutorial.html']").click();
        browser.await(() -> browser.text("h1").equals("An afternoon with a mower"));
        assertThat(browser.text(".contents [aria-current]")).isEqualTo("An afternoon with a mower");
        browser.find("aside a[href='#4-refine']").click();
        browser.await(() -> address().endsWith("#4-refine"));
        // Below what stays at the top.
        assertThat(
                        browser.run(
                                "return"
                                    + " document.getElementById('4-refine').getBoundingClientRect().top"
                                    + " >= document"
                                    + ".querySelector('header').getBoundingClientRect().bottom"))
                .isEqualTo(true);
        browser.find("a[rel=next]").click();
        browser.await(() -> !browser.text("h1").equals("An afternoon with a mower"));
    }

    private void isReadByLightAndInTheDark() {
        for (String scheme : List.of("light", "dark")) {
            browser.wear(scheme);
            for (String page : PAGES) {
                open(page);
                assertThat((List<?>) browser.run(PALE)).as("%s, %s", page, scheme).isEmpty();
                browser.picture("site-" + page.replace('/', '-') + "-" + scheme);
            }
        }
        Object ground = browser.run("return getComputedStyle(document.body).backgroundColor");
        assertThat(ground).isEqualTo("rgb(20, 25, 31)");
    }

    private void fitsAPhone() {
        browser.resize(390, 844);
        for (String page : PAGES) {
            open(page);
            assertThat(browser.run("return document.documentElement.scrollWidth <= 390"))
                    .as(page)
                    .isEqualTo(true);
            browser.picture("site-" + page.replace('/', '-') + "-phone");
        }
        assertThat(browser.find(".contents nav").isDisplayed()).isFalse();
        browser.find(".contents summary").click();
        assertThat(browser.find(".contents nav").isDisplayed()).isTrue();
    }

    private void fitsOnOneSheet() {
        open("docs/learn/cheat-sheet");
        assertThat(browser.sheets()).isEqualTo(1);
        open("docs/tutorial");
        assertThat(browser.sheets()).isGreaterThan(3);
    }
}
