package arcomat.editor.program;

import arcomat.report.page.Browser;

import com.fasterxml.jackson.core.JsonProcessingException;
import com.fasterxml.jackson.databind.ObjectMapper;

import org.openqa.selenium.Keys;

import java.util.ArrayList;
import java.util.List;
import java.util.function.Supplier;

/**
 * Plays a script at VS Code in a browser, a step in each line:
 *
 * <ul>
 *   <li>{@code open FILE}, {@code go LINE:COLUMN}, {@code do COMMAND}: by the means that a person
 *       has at the keyboard
 *   <li>{@code press KEYS}, {@code type TEXT}: in what has the focus
 *   <li>{@code see SELECTOR | TEXT}: waits until an element has the text; {@code unsee} until there
 *       is none
 *   <li>{@code page SELECTOR | TEXT}: the same in the page of a side view; {@code click SELECTOR}
 *       clicks there
 *   <li>{@code picture NAME}: keeps what is to be seen, for people
 * </ul>
 */
record WorkbenchScript(Browser browser) {
    private static final String INPUT = ".quick-input-widget .quick-input-box input:focus";
    private static final String CHOICE = ".quick-input-list .monaco-list-row";
    private static final String SIDE_VIEW = "iframe.webview";
    private static final String PAGE = "#active-frame";

    void run(String line) {
        try {
            step(line);
        } catch (AssertionError e) {
            browser.picture("vscode-failed");
            throw new AssertionError(line, e);
        }
    }

    private void step(String line) {
        String[] words = line.split(" ", 2);
        String rest = words[1].strip();
        switch (words[0]) {
            case "open" -> open(rest);
            case "go" -> go(rest);
            case "do" -> choose(List.of(Keys.F1), rest);
            case "press" -> browser.chord(keys(rest));
            case "type" -> browser.type(rest);
            case "see" -> browser.await(shows(rest));
            case "unsee" -> browser.await(() -> !shows(rest).get());
            case "page" -> browser.await(() -> inPage(shows(rest)));
            case "click" -> browser.await(() -> inPage(() -> click(rest)));
            case "picture" -> browser.picture("vscode-" + rest);
            default -> throw new AssertionError(line);
        }
    }

    private void open(String file) {
        choose(List.of(Keys.CONTROL, "p"), file);
        browser.await(shows(".tab.active | " + file));
        browser.await(shows(".editor-group-container.active .view-line"));
    }

    private void go(String place) {
        browser.chord(List.of(Keys.CONTROL, "g"));
        browser.await(shows(INPUT));
        browser.type(place);
        browser.chord(List.of(Keys.ENTER));
        browser.await(() -> !shows(INPUT).get());
    }

    /** Types into the list that some keys open, until what is wanted is offered. */
    private void choose(List<CharSequence> keys, String wanted) {
        browser.chord(keys);
        browser.await(shows(INPUT));
        browser.type(wanted);
        browser.await(shows(CHOICE + ".focused | " + wanted));
        browser.chord(List.of(Keys.ENTER));
    }

    private static List<CharSequence> keys(String names) {
        List<CharSequence> keys = new ArrayList<>();
        for (String name : names.split("\\+")) {
            keys.add(name.length() == 1 ? name : Keys.valueOf(name));
        }
        return keys;
    }

    private boolean inPage(Supplier<Boolean> question) {
        return browser.inSomeFrame(SIDE_VIEW, PAGE, question);
    }

    /** Whether an element that is to be seen has a text; blanks of an editor are blanks. */
    private Supplier<Boolean> shows(String what) {
        String[] parts = what.split(" \\| ", 2);
        String text = parts.length > 1 ? parts[1] : "";
        String script =
                """
                const shown = (each) => each.getClientRects().length > 0;
                const text = (each) => each.textContent.replace(/\\u00a0/g, ' ');
                return [...document.querySelectorAll(%s)]
                    .some((each) => shown(each) && text(each).includes(%s));
                """
                        .formatted(quoted(parts[0]), quoted(text));
        return () -> Boolean.TRUE.equals(browser.run(script));
    }

    private boolean click(String selector) {
        if (!shows(selector).get()) {
            return false;
        }
        browser.find(selector).click();
        return true;
    }

    private static String quoted(String text) {
        try {
            return new ObjectMapper().writeValueAsString(text);
        } catch (JsonProcessingException e) {
            throw new AssertionError(e);
        }
    }
}
