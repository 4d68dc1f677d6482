package arcomat.pipeline.live;

import arcomat.pipeline.WrongUse;
import arcomat.pipeline.file.Failures;
import arcomat.report.text.Json;
import arcomat.source.SourceFile;

import java.io.IOException;
import java.net.URISyntaxException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;

/**
 * The page as it lies in the folder {@code live} beside the tool's jar. It is one file, in which
 * the models have a place of their own.
 */
record LivePage(String html) {
    private static final String FILE = "live/index.html";

    /** Where the models are: until the end of that script. */
    private static final String MODELS = "<script id=\"models\" type=\"application/json\">";

    private static final String END = "</script>";

    /**
     * What the page begins with.
     *
     * @param files to be worked on
     * @param needed lie around them
     */
    record Beginning(List<Text> files, List<Text> needed) {}

    /** A file as the page has it. */
    record Text(String path, String text) {
        static Text of(SourceFile file) {
            return new Text(file.path(), file.text());
        }
    }

    /**
     * @throws WrongUse where it is not there, as in a build that has installed nothing
     */
    static LivePage installed() throws WrongUse {
        try {
            Path tool =
                    Path.of(
                            LivePage.class
                                    .getProtectionDomain()
                                    .getCodeSource()
                                    .getLocation()
                                    .toURI());
            Path page = tool.resolveSibling(FILE);
            if (!Files.isRegularFile(page)) {
                throw new WrongUse(
                        "the live page is missing: it is lib/%s of an installation", FILE);
            }
            return new LivePage(Files.readString(page));
        } catch (IOException | URISyntaxException e) {
            throw Failures.cannot("read", "lib/" + FILE, e);
        }
    }

    /** The page with other models than those that it has. */
    String with(Beginning models) {
        int from = html.indexOf(MODELS) + MODELS.length();
        int to = html.indexOf(END, from);
        return html.substring(0, from) + harmless(Json.compact(models)) + html.substring(to);
    }

    /** Nothing that a model says ends the script that it stands in. */
    private static String harmless(String json) {
        return json.replace("<", "\\u003c");
    }
}
