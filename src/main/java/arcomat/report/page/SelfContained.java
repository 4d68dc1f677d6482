package arcomat.report.page;

import arcomat.report.text.Printable;
import arcomat.source.Sha256;

import java.io.IOException;
import java.io.InputStream;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.util.Base64;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Collectors;

/**
 * An HTML page that loads nothing. A browser runs nothing of it but the script of this tool, which
 * the page's policy names by its hash: whatever models call their things stays text.
 */
public final class SelfContained {
    private static final String FOLDER = "/report/";
    private static final Pattern SLOT = Pattern.compile("\\{\\{([a-z]+)}}");

    private SelfContained() {}

    /**
     * Fills a template.
     *
     * @param template a file of {@code resources/report}, with slots {@code policy}, {@code style}
     *     and {@code script}, and others
     * @param style the style sheet
     * @param scripts files of {@code resources/report} in the order in which they build on each
     *     other
     * @param slots texts of the other slots, already escaped
     */
    public static String render(
            String template, String style, List<String> scripts, Map<String, String> slots) {
        String script = "\"use strict\";\n(() => {\n" + join(scripts) + "})();\n";
        Map<String, String> all = new HashMap<>(slots);
        all.put("policy", policy(style, script));
        all.put("style", style);
        all.put("script", script);
        return SLOT.matcher(read(template))
                .replaceAll(slot -> Matcher.quoteReplacement(all.get(slot.group(1))));
    }

    /** Nothing from anywhere; of scripts and styles, only these. */
    private static String policy(String style, String script) {
        return "default-src 'none'; style-src '%s'; script-src '%s'; base-uri 'none'; form-action 'none'"
                .formatted(hash(style), hash(script));
    }

    private static String hash(String text) {
        return "sha256-" + Base64.getEncoder().encodeToString(Sha256.of(text));
    }

    /** Files of {@code resources/report}, one after the other. */
    public static String join(List<String> names) {
        return names.stream().map(SelfContained::read).collect(Collectors.joining("\n"));
    }

    private static String read(String name) {
        try (InputStream in = SelfContained.class.getResourceAsStream(FOLDER + name)) {
            return new String(in.readAllBytes(), StandardCharsets.UTF_8);
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
    }

    /** A text as a part of markup. */
    public static String escaped(String text) {
        return Printable.escape(text)
                .replace("&", "&amp;")
                .replace("<", "&lt;")
                .replace(">", "&gt;")
                .replace("\"", "&quot;");
    }

    /** JSON such that nothing in it begins a tag: outside of texts it has none of these. */
    public static String harmless(String json) {
        return json.replace("<", "\\u003c").replace(">", "\\u003e").replace("&", "\\u0026");
    }
}
