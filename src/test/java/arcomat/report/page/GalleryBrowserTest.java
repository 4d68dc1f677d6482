package arcomat.report.page;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import arcomat.pipeline.Progress;
import arcomat.pipeline.Session;
import arcomat.pipeline.WrongUse;
import arcomat.pipeline.diagram.DrawDiagrams;
import arcomat.pipeline.diagram.MarkedFindings;
import arcomat.pipeline.picture.PictureFormat;

import org.junit.jupiter.api.function.Executable;
import org.openqa.selenium.Keys;
import org.openqa.selenium.WebElement;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;

/**
 * The page around pictures under the hands of somebody: what lights up, folds, grows and is found.
 */
class GalleryBrowserTest extends BrowserTest {
    private static final String NEST =
            """
            component Nest {
              port in Integer press, out Integer lamp, out Integer bell;
              component Cell {
                port in Integer a, out Integer b;
                automaton { state s; initial s / {b = 0}; s {a == 1} / {b = 1}; }
              }
              component Box {
                port in Integer a, out Integer b;
                component Cell first;
                component Cell second;
                connect a -> first.a;
                connect first.b -> second.a;
                connect second.b -> b;
              }
              component Box outer;
              component Cell last;
              connect press -> outer.a;
              connect outer.b -> last.a, bell;
              connect last.b -> lamp;
            }
            """;

    private static final String DOOR =
            """
            component Door {
              port in Boolean button, out Boolean open;
              <<completion = "ignore">> automaton {
                state closed, opened, locked;
                initial closed;
                closed -> opened {button == true} / {open = true};
                opened -> closed {button == false} / {open = false};
                opened -> locked {button == true} / {open = false};
                closed -> locked {button == false} / {open = false};
              }
            }
            """;

    private static final String WINDOW = "#Nest .viewer-window";

    @Override
    protected Map<String, Executable> tests() {
        Map<String, Executable> tests = new LinkedHashMap<>();
        tests.put("a wire lights up through borders", this::aWireLightsUp);
        tests.put("all of a part lights up", this::aPartLightsUp);
        tests.put("ways that are joined light up", this::joinedWaysLightUp);
        tests.put("parts are closed and opened", this::partsAreClosed);
        tests.put("what is closed shrinks", this::whatIsClosedShrinks);
        tests.put("keys make it larger and move it", this::keysMakeItLarger);
        tests.put("a click leaves the keys to the page", this::aClickLeavesTheKeys);
        tests.put("texts are found", this::textsAreFound);
        tests.put("pictures are found by name", this::picturesAreFound);
        tests.put("the legend has what is there", this::theLegendHasWhatIsThere);
        tests.put("paper has all of it", this::paperHasAll);
        tests.put("a phone", this::fitsAPhone);
        tests.put("images", this::imagesAreShown);
        tests.put("colours", this::coloursCanBeRead);
        return tests;
    }

    private void open(PictureFormat format) throws IOException, WrongUse {
        Path models = Files.createDirectories(folder.resolve("models"));
        Files.writeString(models.resolve("Nest.arc"), NEST);
        Files.writeString(models.resolve("Door.arc"), DOOR);
        DrawDiagrams task =
                new DrawDiagrams(
                        List.of("Nest", "Door"),
                        format,
                        folder.resolve("out").toString(),
                        100,
                        MarkedFindings.NONE,
                        List.of(models.toString()));
        Session.in(folder, Progress.NONE).run(task).value().orElseThrow();
        browser.open(folder.resolve("out/index.html").toUri().toString(), "section");
        browser.resize(1440, 900);
    }

    private void open() throws IOException, WrongUse {
        open(PictureFormat.svg);
    }

    private void point(String selector) {
        browser.run(
                "document.querySelector('%s').dispatchEvent(new MouseEvent('mouseover', {bubbles: true}))"
                        .formatted(selector));
    }

    /** Names of what is lit, of a kind. */
    private List<String> lit(String kind) {
        return browser.findAll("." + kind + ".lit").stream()
                .map(each -> each.getDomAttribute("data-" + kind))
                .toList();
    }

    private void aWireLightsUp() throws Exception {
        open();
        point("#Nest [data-connector=\"outer.second.b -> b\"] path");
        assertThat(lit("connector"))
                .containsExactlyInAnyOrder(
                        "outer.second.b -> b", "outer.b -> last.a", "outer.b -> bell");
        assertThat(lit("port"))
                .containsExactlyInAnyOrder("outer.second.b", "outer.b", "last.a", "bell");
        browser.picture("gallery-light");
    }

    private void aPartLightsUp() throws Exception {
        open();
        point("#Nest [data-part=\"last\"] rect");
        assertThat(lit("connector"))
                .containsExactlyInAnyOrder(
                        "outer.second.b -> b",
                        "outer.b -> last.a",
                        "outer.b -> bell",
                        "last.b -> lamp");
    }

    /** Both ways into the locked state, which share a label, but not those to other states. */
    private void joinedWaysLightUp() throws Exception {
        open();
        browser.picture("gallery-automaton-light");
        point("#Door [data-state=\"2\"] rect");
        assertThat(lit("state")).containsExactlyInAnyOrder("0", "1", "2");
        assertThat(lit("transition")).containsExactlyInAnyOrder("2", "3");
        point("#Door [data-transition=\"1\"] text");
        assertThat(lit("transition")).containsExactly("1");
        assertThat(lit("state")).containsExactlyInAnyOrder("0", "1");
    }

    private void partsAreClosed() throws Exception {
        open();
        browser.press(Keys.chord(Keys.TAB));
        browser.run("document.querySelector('#Nest .fold').focus()");
        browser.press(Keys.ENTER);
        assertThat(browser.find("#Nest .fold").getDomAttribute("aria-expanded")).isEqualTo("false");
        assertThat(isSeen("#Nest [data-part=\"outer.first\"]")).isFalse();
        assertThat(isSeen("#Nest [data-connector=\"outer.second.b -> b\"]")).isFalse();
        assertThat(isSeen("#Nest [data-port=\"outer.a\"]")).isTrue();
        assertThat(isSeen("#Nest [data-part=\"last\"]")).isTrue();
        browser.picture("gallery-closed");
        browser.find("#Nest [data-do=fold]").click();
        assertThat(isSeen("#Nest [data-part=\"outer.first\"]")).isTrue();
        assertThat(browser.find("#Door [data-do=fold]").isDisplayed()).isFalse();
    }

    /** Wires that are seen and do not begin or end at their ports. */
    private static final String LOOSE =
            """
            const box = (port) => document.querySelector(`#Nest [data-port="${port}"] rect`).getBBox();
            const isAt = (place, port) => {
              const { x, y, width, height } = box(port);
              return [x, x + width].some((side) => Math.abs(place.x - side) < 1) && place.y > y && place.y < y + height;
            };
            return [...document.querySelectorAll("#Nest .connector:not(.hidden-inside)")]
              .filter((wire) => {
                const [head] = wire.querySelector("polygon").points;
                return !isAt(wire.querySelector("path").getPointAtLength(0), wire.dataset.from) || !isAt(head, wire.dataset.to);
              })
              .map((wire) => wire.dataset.connector);
            """;

    private static final String EXTENT =
            """
            const { width, height } = document.querySelector("#Nest svg").viewBox.baseVal;
            const box = document.querySelector("#Nest [data-part=outer] rect");
            return [width, height, box.getAttribute("width"), box.getAttribute("height")].map(Number);
            """;

    /** As small as the other one, which has nothing inside to show, and the whole by as much. */
    private void whatIsClosedShrinks() throws Exception {
        open();
        List<?> open = (List<?>) browser.run(EXTENT);
        browser.find("#Nest [data-do=fold]").click();
        List<?> closed = (List<?>) browser.run(EXTENT);
        double width =
                Double.parseDouble(
                        browser.find("#Nest [data-part=last] rect").getDomAttribute("width"));
        assertThat(number(closed, 2)).isBetween(width - 10, width + 10);
        assertThat(number(closed, 3)).isEqualTo(70);
        assertThat(number(open, 0) - number(closed, 0))
                .as("the columns that are empty now, but for a gap")
                .isCloseTo(number(open, 2) - number(closed, 2) - 10, within(5.0));
        assertThat((List<?>) browser.run(LOOSE)).isEmpty();
        browser.find("#Nest [data-do=fold]").click();
        assertThat((List<?>) browser.run(EXTENT)).as("as it was").isEqualTo(open);
        assertThat((List<?>) browser.run(LOOSE)).isEmpty();
    }

    private static double number(List<?> numbers, int which) {
        return ((Number) numbers.get(which)).doubleValue();
    }

    private boolean isSeen(String selector) {
        return browser.find(selector).isDisplayed();
    }

    private void keysMakeItLarger() throws Exception {
        open();
        browser.run("document.querySelector('" + WINDOW + "').focus()");
        assertThat(scale()).isEqualTo("100 %");
        browser.press("+", "+", "+");
        assertThat(scale()).isEqualTo("195 %");
        browser.press(Keys.ARROW_RIGHT);
        Object before = scrolled();
        browser.press(Keys.ARROW_RIGHT);
        browser.await(() -> !scrolled().equals(before));
        browser.press("-");
        assertThat(scale()).isEqualTo("156 %");
        browser.press("0");
        assertThat(scale()).isEqualTo("100 %");
    }

    private String scale() {
        return browser.text("#Nest [data-do=actual]");
    }

    private Object scrolled() {
        return browser.run("return document.querySelector('" + WINDOW + "').scrollLeft");
    }

    private void aClickLeavesTheKeys() throws Exception {
        open();
        browser.find("#Nest [data-part=last] text").click();
        assertThat(browser.run("return document.activeElement === document.body")).isEqualTo(true);
    }

    /** Also in a part that is closed: then it is opened. */
    private void textsAreFound() throws Exception {
        open();
        browser.find("#Nest [data-do=fold]").click();
        browser.run("document.querySelector('" + WINDOW + "').focus()");
        browser.press("/");
        browser.type("SECOND: nest");
        assertThat(browser.text("#Nest output")).isEqualTo("1 found");
        browser.press(Keys.ENTER);
        assertThat(browser.text("#Nest output")).isEqualTo("1 of 1: second: Nest.Cell");
        assertThat(isSeen("#Nest [data-part=\"outer.second\"]")).isTrue();
        assertThat(lit("part")).containsExactly("outer.second");
        browser.press(Keys.ESCAPE);
        assertThat(browser.text("#Nest output")).isEmpty();
        browser.press("/");
        browser.type("nobody");
        assertThat(browser.text("#Nest output")).isEqualTo("not found");
    }

    private void picturesAreFound() throws Exception {
        open();
        browser.find("#filter").sendKeys("doo");
        assertThat(isSeen("#Door")).isTrue();
        assertThat(isSeen("#Nest")).isFalse();
        assertThat(browser.findAll("nav li").stream().filter(WebElement::isDisplayed)).hasSize(1);
    }

    private void theLegendHasWhatIsThere() throws Exception {
        open();
        browser.find("#Nest summary").click();
        assertThat(browser.text("#Nest .viewer-legend")).contains("a wire forks", "logic");
        assertThat(browser.text("#Nest .viewer-legend")).doesNotContain("sensors", "begins here");
        browser.find("#Door summary").click();
        assertThat(browser.text("#Door .viewer-legend")).contains("begins here");
        browser.picture("gallery-legend-light");
    }

    /** However large it was on the screen. */
    private void paperHasAll() throws Exception {
        open();
        browser.run("document.querySelector('" + WINDOW + "').focus()");
        browser.press("+", "+", "+", "+", "+");
        browser.print();
        Object width =
                browser.run(
                        "const all = document.querySelector('#Nest .viewer-window');"
                                + " return all.scrollWidth <= all.clientWidth");
        assertThat(width).isEqualTo(true);
        assertThat(isSeen("#Nest .viewer-tools")).isFalse();
        browser.picture("gallery-printed");
    }

    private void fitsAPhone() throws Exception {
        open();
        browser.resize(390, 844);
        assertThat(browser.run("return document.documentElement.scrollWidth <= 390"))
                .isEqualTo(true);
        browser.picture("gallery-phone-light");
    }

    private void imagesAreShown() throws Exception {
        open(PictureFormat.png);
        browser.await(
                () ->
                        browser.run("return document.querySelector('#Door img').naturalWidth > 0")
                                .equals(true));
        assertThat(browser.find("#Door img").getDomAttribute("alt")).isEqualTo("Door");
    }

    private void coloursCanBeRead() throws Exception {
        open();
        point("#Door [data-state=\"2\"] rect");
        assertThat(Contrast.faintTexts(browser)).isEmpty();
        browser.wear("dark");
        assertThat(Contrast.faintTexts(browser)).isEmpty();
        browser.picture("gallery-dark");
    }
}
