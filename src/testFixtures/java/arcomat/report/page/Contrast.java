package arcomat.report.page;

import java.io.IOException;
import java.io.InputStream;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.util.List;

/** Whether all that a page says can be read, by its colours. */
public final class Contrast {
    private static final int WIDTH = 1440;
    private static final int HEIGHT = 5000;

    private Contrast() {}

    /** Texts whose contrast to what is behind them is less than 4.5, wherever on the page. */
    public static List<String> faintTexts(Browser browser) {
        browser.resize(WIDTH, HEIGHT);
        return ((List<?>) browser.run(script())).stream().map(String::valueOf).toList();
    }

    private static String script() {
        try (InputStream in = Contrast.class.getResourceAsStream("/report/contrast.js")) {
            return new String(in.readAllBytes(), StandardCharsets.UTF_8);
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
    }
}
