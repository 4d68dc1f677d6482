package arcomat.live;

import arcomat.report.page.Browser;
import arcomat.report.text.Json;

import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.Base64;
import java.util.List;
import java.util.Map;
import java.util.zip.Deflater;
import java.util.zip.DeflaterOutputStream;

/** The page in a browser, and its core asked as the page asks it. */
record LivePage(Browser browser) {
    static final Path FILE = Path.of(System.getProperty("live.page"));

    /** Opens the page as it comes, and waits until it has checked its models. */
    static LivePage open(Browser browser) {
        browser.open(FILE.toUri().toString(), "body[data-checked]");
        return new LivePage(browser);
    }

    /** A state of the page as its address has it. */
    static String packed(String state) {
        Deflater deflater = new Deflater(Deflater.DEFAULT_COMPRESSION, true);
        ByteArrayOutputStream packed = new ByteArrayOutputStream();
        try (DeflaterOutputStream out = new DeflaterOutputStream(packed, deflater)) {
            out.write(state.getBytes(StandardCharsets.UTF_8));
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        } finally {
            deflater.end();
        }
        return Base64.getUrlEncoder().withoutPadding().encodeToString(packed.toByteArray());
    }

    /** What the core in the browser says. */
    String ask(String question, Object... arguments) {
        browser.run(
                "window.told = undefined; page.second = page.second || new page.desk.constructor();"
                        + "page.second.ask('%s', ...%s).then(a => window.told = a, e => window.told = String(e));"
                                .formatted(question, Json.compact(List.of(arguments))));
        browser.await(() -> (Boolean) browser.run("return window.told !== undefined"));
        return (String) browser.run("return window.told");
    }

    /** Lays models on the desk of the core; the answer tells what is wrong with them. */
    String check(Map<String, String> texts) {
        return ask("check", texts.keySet(), texts.values(), List.of());
    }
}
