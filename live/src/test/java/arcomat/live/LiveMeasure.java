package arcomat.live;

import arcomat.report.page.Browser;
import arcomat.report.text.Json;

import java.time.Duration;
import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.Locale;
import java.util.Map;

/**
 * How long one waits on the page: for its first answer, and after a key in a model of 275 lines.
 * Times are taken by the page itself, from the key to the findings on the screen. Keys are the
 * first ones on a page that has just been opened, whose browser has made nothing fast yet.
 */
final class LiveMeasure {
    private static final int STARTS = 5;

    /** Time between keys of somebody who types fast, in milliseconds. */
    private static final int PAUSE = 120;

    private static final String WRITTEN =
            "\n            dark -> bright {own == true, left == false} / {right = true};";

    /** Types letter by letter where the cursor stands, and keeps how long each one took. */
    private static final String TYPE =
            """
            window.times = undefined;
            (async () => {
                const times = [], view = page.editor.view;
                const shown = () => new Promise((done) => new MutationObserver((all, self) => {
                    self.disconnect();
                    done();
                }).observe(document.body, { attributes: true, attributeFilter: ['data-found'] }));
                for (const letter of %s) {
                    const at = view.state.selection.main.head, seen = shown(), begun = performance.now();
                    view.dispatch({ changes: { from: at, insert: letter }, selection: { anchor: at + 1 }, userEvent: 'input.type' });
                    await seen;
                    times.push(performance.now() - begun);
                    await new Promise((done) => setTimeout(done, %d));
                }
                window.times = times;
            })();
            """;

    private LiveMeasure() {}

    public static void main(String[] arguments) {
        try (Browser browser = new Browser(Duration.ofMinutes(3))) {
            List<Double> first = new ArrayList<>();
            for (int i = 0; i < STARTS; i++) {
                browser.open("about:blank", "html");
                LivePage.open(browser);
                first.add(
                        number(
                                browser.run(
                                        "return performance.getEntriesByName('first"
                                                + " answer')[0].startTime")));
            }
            say("first answer after the page is opened", first, 1000);
            load(browser);
            List<Double> times = new ArrayList<>();
            for (int i = 0; i < 3; i++) {
                load(browser);
                times.addAll(typed(browser, WRITTEN));
            }
            say("from a key to the findings, 275 lines in a file", times, 20);
        }
    }

    private static void load(Browser browser) {
        String start =
                Json.compact(
                        Map.of(
                                "files",
                                List.of(Map.of("path", "Chain.arc", "text", ChainModel.TEXT))));
        browser.open("about:blank", "html");
        browser.open(LivePage.FILE.toUri() + "#" + LivePage.packed(start), "body[data-drawn]");
        int at = ChainModel.PLACE;
        browser.run("page.editor.view.dispatch({selection: {anchor: %d}})".formatted(at));
    }

    private static List<Double> typed(Browser browser, String text) {
        browser.run(TYPE.formatted(Json.compact(List.of(text.split(""))), PAUSE));
        browser.await(() -> Boolean.TRUE.equals(browser.run("return window.times !== undefined")));
        List<Double> times = new ArrayList<>();
        ((List<?>) browser.run("return window.times")).forEach(each -> times.add(number(each)));
        return times;
    }

    private static double number(Object value) {
        return ((Number) value).doubleValue();
    }

    private static void say(String what, List<Double> times, int aim) {
        List<Double> sorted = new ArrayList<>(times);
        Collections.sort(sorted);
        System.out.printf(
                Locale.ROOT,
                "%-50s median %.1f ms, nine of ten below %.1f ms, %d times; aim %d ms%n",
                what,
                sorted.get(sorted.size() / 2),
                sorted.get(sorted.size() * 9 / 10),
                sorted.size(),
                aim);
    }
}
