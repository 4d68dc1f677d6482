package arcomat.report.page;

import arcomat.diagram.Theme;
import arcomat.report.Printable;

import java.io.IOException;
import java.io.InputStream;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.security.MessageDigest;
import java.security.NoSuchAlgorithmException;
import java.util.Base64;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Collectors;

/**
 * Writes a page as HTML. It loads nothing, and a browser runs nothing of it but the script of this
 * tool, which the page's policy names by its hash: whatever models call their ports stays text.
 */
public final class PageText {
    private static final String FOLDER = "/report/";

    /** In the order in which they build on each other. */
    private static final List<String> SCRIPTS =
            List.of(
                    "elements.js",
                    "tracks.js",
                    "view.js",
                    "lanes.js",
                    "timeline.js",
                    "moment.js",
                    "pictures.js",
                    "remarks.js",
                    "search.js",
                    "stories.js",
                    "keys.js",
                    "main.js");

    private static final List<String> STYLES =
            List.of("colours.css", "page.css", "timeline.css", "moment.css");
    private static final Pattern SLOT = Pattern.compile("\\{\\{([a-z]+)}}");

    private PageText() {}

    public static String render(Page page) {
        String style = Theme.ADAPTIVE.css() + join(STYLES);
        String script = "\"use strict\";\n(() => {\n" + join(SCRIPTS) + "})();\n";
        Map<String, String> slots =
                Map.of(
                        "policy", policy(style, script),
                        "style", style,
                        "script", script,
                        "title", escaped(page.title()),
                        "command", escaped(page.command()),
                        "tone", page.tone().name().toLowerCase(Locale.ROOT),
                        "headline", escaped(page.headline()),
                        "pictures", pictures(page),
                        "data", PageData.render(page));
        return fill(resource("page.html"), slots);
    }

    /** Nothing from anywhere; of scripts and styles, only these. */
    private static String policy(String style, String script) {
        return "default-src 'none'; style-src '%s'; script-src '%s'; base-uri 'none'; form-action 'none'"
                .formatted(hash(style), hash(script));
    }

    private static String hash(String text) {
        try {
            byte[] digest =
                    MessageDigest.getInstance("SHA-256")
                            .digest(text.getBytes(StandardCharsets.UTF_8));
            return "sha256-" + Base64.getEncoder().encodeToString(digest);
        } catch (NoSuchAlgorithmException e) {
            throw new AssertionError("every Java has SHA-256", e);
        }
    }

    private static String pictures(Page page) {
        return PageData.pictures(page).keySet().stream()
                .map(svg -> "<template class=\"picture\">" + svg + "</template>\n")
                .collect(Collectors.joining());
    }

    private static String fill(String template, Map<String, String> slots) {
        return SLOT.matcher(template)
                .replaceAll(slot -> Matcher.quoteReplacement(slots.get(slot.group(1))));
    }

    private static String join(List<String> names) {
        return names.stream().map(PageText::resource).collect(Collectors.joining("\n"));
    }

    private static String resource(String name) {
        try (InputStream in = PageText.class.getResourceAsStream(FOLDER + name)) {
            return new String(in.readAllBytes(), StandardCharsets.UTF_8);
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
    }

    private static String escaped(String text) {
        return Printable.escape(text)
                .replace("&", "&amp;")
                .replace("<", "&lt;")
                .replace(">", "&gt;")
                .replace("\"", "&quot;");
    }
}
