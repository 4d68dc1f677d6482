package arcomat.report.page;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Assumptions;
import org.junit.jupiter.api.DynamicTest;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.TestFactory;
import org.junit.jupiter.api.function.Executable;
import org.junit.jupiter.api.io.TempDir;

import java.nio.file.Path;
import java.util.Map;
import java.util.stream.Stream;

/** Tests that share a browser, and are skipped where there is none. */
@Tag("browser")
public abstract class BrowserTest {
    @TempDir protected Path folder;
    protected Browser browser;

    /** The tests by their names. None may leave a complaint on the console. */
    protected abstract Map<String, Executable> tests();

    @TestFactory
    final Stream<DynamicTest> pages() {
        if (!Browser.isThere()) {
            return Stream.of(
                    DynamicTest.dynamicTest(
                            "skipped: there is no 'chromium' with 'chromedriver' on this machine",
                            () -> Assumptions.abort("no browser")));
        }
        browser = new Browser();
        return tests().entrySet().stream()
                .map(test -> DynamicTest.dynamicTest(test.getKey(), () -> check(test.getValue())));
    }

    private void check(Executable test) throws Throwable {
        browser.wear("light");
        test.execute();
        assertThat(browser.problems()).as("what the console says").isEmpty();
    }

    @AfterEach
    final void close() {
        if (browser != null) {
            browser.close();
        }
    }

    /** The number of the step that a page shows. */
    protected String step() {
        return browser.find("#step").getDomProperty("value");
    }
}
