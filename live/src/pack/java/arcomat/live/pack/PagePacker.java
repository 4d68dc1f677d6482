package arcomat.live.pack;

import java.io.File;
import java.io.IOException;
import java.io.InputStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.regex.Pattern;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import java.util.zip.ZipEntry;
import java.util.zip.ZipFile;

/**
 * Puts the page together: one file. A browser loads no module from beside a page that is a file, so
 * that all of them lie in it. What is not needed at once lies there as text.
 */
public final class PagePacker {
    /** In the order in which they use each other. */
    private static final List<String> MODULES =
            List.of(
                    "elements",
                    "desk",
                    "address",
                    "editor",
                    "findings",
                    "picture",
                    "run",
                    "prove",
                    "floor",
                    "main");

    /** What plays runs on pages of {@code arcomat world}, in the order in which it is used. */
    private static final List<String> REPLAY =
            List.of(
                    "elements",
                    "replay/recording",
                    "replay/labels",
                    "replay/ghost",
                    "replay/floor",
                    "replay/cards",
                    "replay/happenings",
                    "replay/player",
                    "replay/stage");

    /** Windows of pictures, as on pages of reports. */
    private static final List<String> PICTURES =
            List.of(
                    "picture/wires",
                    "picture/folds",
                    "picture/finder",
                    "picture/legend",
                    "picture/viewer");

    /** Libraries that ask for each other by name; in their jars, by the ends of their paths. */
    private static final Map<String, String> LIBRARIES = libraries();

    /**
     * Comments that have lines of their own: a third of those libraries, and some of our scripts
     * and styles.
     */
    private static final Pattern COMMENT =
            Pattern.compile("(?m)^[ \\t]*(//.*|/\\*(?s:.*?)\\*/[ \\t]*)\\n");

    /** Comments behind code; with a quote it might be the rest of a string. */
    private static final Pattern REMARK = Pattern.compile("(?m)[ \\t]+//[^\\n'\"`]*$");

    /** Empty lines as well. */
    private static final Pattern INDENTATION = Pattern.compile("(?m)^\\s+");

    private static final String LAYOUT = "klay.js";
    private static final String EXPORT = "export ";

    private PagePacker() {}

    private static Map<String, String> libraries() {
        Map<String, String> libraries = new LinkedHashMap<>();
        libraries.put("@marijn/find-cluster-break", "marijn__find-cluster-break");
        libraries.put("crelt", "crelt");
        libraries.put("style-mod", "style-mod");
        libraries.put("w3c-keyname", "w3c-keyname");
        libraries.put("@lezer/common", "lezer__common");
        libraries.put("@lezer/highlight", "lezer__highlight");
        Stream.of("state", "view", "language", "commands", "search", "autocomplete", "lint")
                .forEach(name -> libraries.put("@codemirror/" + name, "codemirror__" + name));
        return libraries;
    }

    /**
     * @param args the folder of the page's sources; the core; style sheets; jars with libraries;
     *     the folder of what pages of reports have; the file to write
     */
    public static void main(String[] args) throws IOException {
        Path sources = Path.of(args[0]);
        List<Path> jars = paths(args[3]);
        StringBuilder styles = new StringBuilder();
        for (Path sheet : paths(args[2])) {
            styles.append(Files.readString(sheet));
        }
        Path report = Path.of(args[4]);
        styles.append(Files.readString(report.resolve("picture/viewer.css")));
        styles.append(Files.readString(report.resolve("replay/floor.css")));
        // Its rules are for a page of its own; here they hold in one view.
        styles.append("#floor {\n" + Files.readString(report.resolve("replay/replay.css")) + "}\n");
        styles.append(Files.readString(sources.resolve("live.css")));
        List<String> scripts = new ArrayList<>();
        scripts.add(kept("code-core", PackedCore.script(Path.of(args[1]))));
        scripts.add(kept("code-worker", worker(sources)));
        scripts.add(script("", shortened(Files.readString(sources.resolve("beginning.js")))));
        scripts.add(kept("code-layout", read(jars, "klayjs", LAYOUT)));
        String example = Files.readString(sources.resolve("example.json"));
        scripts.add("<script id=\"models\" type=\"application/json\">" + example + "</script>");
        scripts.add(kept("licence", read(jars, "codemirror__view", "LICENSE")));
        scripts.add(script("", bundle(jars)));
        scripts.add(script("", shared("replay", REPLAY, "{ Recording, Stage }", report)));
        scripts.add(script("", shared("PictureViewer", PICTURES, "PictureViewer", report)));
        scripts.add(script(" type=\"module\"", modules(sources)));
        String page =
                Files.readString(sources.resolve("page.html"))
                        .replace("@styles@", shortened(styles.toString()))
                        .replace("@scripts@", String.join("\n", scripts));
        Files.writeString(Path.of(args[5]), page);
    }

    private static List<Path> paths(String list) {
        return Stream.of(list.split(File.pathSeparator)).map(Path::of).toList();
    }

    /** The modules one after the other, as if they were one; no two define the same name. */
    private static String modules(Path sources) throws IOException {
        StringBuilder all = new StringBuilder();
        for (String name : MODULES) {
            String text = shortened(Files.readString(sources.resolve(name + ".js")));
            all.append(
                    text.lines()
                            .filter(line -> !line.startsWith("import "))
                            .map(
                                    line ->
                                            line.startsWith(EXPORT)
                                                    ? line.substring(EXPORT.length())
                                                    : line)
                            .collect(Collectors.joining("\n", "", "\n")));
        }
        return all.toString();
    }

    /** Scripts that know each other by name, and of which the page needs a part, under a name. */
    private static String shared(String name, List<String> files, String part, Path report)
            throws IOException {
        StringBuilder all = new StringBuilder("const " + name + " = (() => {\n");
        for (String file : files) {
            all.append(shortened(Files.readString(report.resolve(file + ".js"))));
        }
        return all.append("return " + part + ";\n})();\n").toString();
    }

    /** Libraries as functions that are called where somebody first asks for them. */
    private static String bundle(List<Path> jars) throws IOException {
        StringBuilder all = new StringBuilder();
        all.append("const libraries = {}, loaded = {};\n");
        all.append(
                """
                function require(name) {
                    if (!loaded[name]) {
                        const module = { exports: {} };
                        loaded[name] = module;
                        libraries[name](module, module.exports, require);
                    }
                    return loaded[name].exports;
                }
                """);
        for (Map.Entry<String, String> library : LIBRARIES.entrySet()) {
            all.append(
                    "libraries['"
                            + library.getKey()
                            + "'] = function (module, exports, require) {\n");
            String code = read(jars, library.getValue(), ".cjs");
            all.append(shortened(code)).append("\n};\n");
        }
        return all.toString();
    }

    /** For browsers alone: people read scripts and styles where they are written. */
    private static String shortened(String code) {
        String bare = REMARK.matcher(COMMENT.matcher(code).replaceAll("")).replaceAll("");
        return INDENTATION.matcher(bare).replaceAll("");
    }

    /** The one file of a library whose path ends so. */
    private static String read(List<Path> jars, String library, String ending) throws IOException {
        for (Path jar : jars) {
            if (jar.getFileName().toString().startsWith(library + "-")) {
                try (ZipFile zip = new ZipFile(jar.toFile())) {
                    return read(zip, ending);
                }
            }
        }
        throw new IllegalStateException("there is no library " + library);
    }

    private static String read(ZipFile zip, String ending) throws IOException {
        List<? extends ZipEntry> found =
                zip.stream()
                        .filter(entry -> entry.getName().endsWith(ending))
                        .filter(entry -> !entry.getName().endsWith(".d" + ending))
                        .toList();
        if (found.size() != 1) {
            throw new IllegalStateException(zip.getName() + " has " + found + " for " + ending);
        }
        try (InputStream in = zip.getInputStream(Objects.requireNonNull(found.get(0)))) {
            return new String(in.readAllBytes(), StandardCharsets.UTF_8);
        }
    }

    /** What unpacks and asks the core, in the order in which it is used. */
    private static String worker(Path sources) throws IOException {
        StringBuilder all = new StringBuilder();
        for (String name : List.of("unpack", "core", "worker")) {
            all.append(shortened(Files.readString(sources.resolve(name + ".js"))));
        }
        return all.toString();
    }

    /** Kept until it is asked for. */
    private static String kept(String id, String code) {
        return "<script id=\"" + id + "\" type=\"text/plain\">" + harmless(code) + "\n</script>";
    }

    private static String script(String attributes, String code) {
        return "<script" + attributes + ">\n" + harmless(code) + "\n</script>";
    }

    /**
     * What would end a script stands in strings and comments only, where a backslash is nothing.
     */
    private static String harmless(String code) {
        return code.replace("</script", "<\\/script").replace("<!--", "<\\!--");
    }
}
