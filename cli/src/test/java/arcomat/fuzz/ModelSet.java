package arcomat.fuzz;

import arcomat.models.ModelFiles;
import arcomat.source.SourceFile;
import arcomat.syntax.Parsed;
import arcomat.syntax.Parser;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Map;
import java.util.TreeMap;
import java.util.regex.Matcher;
import java.util.regex.Pattern;

/**
 * Files that are models together.
 *
 * @param files by path
 */
public record ModelSet(String name, TreeMap<String, Parsing> files) {
    private static final Pattern FENCE =
            Pattern.compile("(?ms)^```(arc|cd|mt|ioautomaton)\n(.*?)^```$");
    private static final Pattern DEFINITION =
            Pattern.compile("(?m)^(?:component|automaton|classdiagram|testsuite) (\\w+)");

    /** A file and, once it is asked for, what the parser makes of it. */
    public static final class Parsing {
        private final SourceFile file;
        private Parsed parsed;

        Parsing(String path, String text) {
            file = new SourceFile(path, text);
        }

        public SourceFile file() {
            return file;
        }

        Parsed parsed() {
            if (parsed == null) {
                parsed = Parser.parse(file);
            }
            return parsed;
        }
    }

    /** The files of a folder, with what they need of the library. */
    public static ModelSet folder(String name, Path root) {
        TreeMap<String, Parsing> files = new TreeMap<>();
        for (SourceFile file : ModelFiles.of(root)) {
            files.put(file.path(), new Parsing(file.path(), file.text()));
        }
        return new ModelSet(name, files);
    }

    /** The examples of a page that are not about older tools: together they are one model. */
    public static ModelSet page(String name, Path page) {
        TreeMap<String, Parsing> files = new TreeMap<>();
        Matcher fence = FENCE.matcher(read(page));
        while (fence.find()) {
            Matcher definition = DEFINITION.matcher(fence.group(2));
            if (definition.find()) {
                String path = "tour/" + definition.group(1) + "." + fence.group(1);
                files.put(path, new Parsing(path, fence.group(2)));
            }
        }
        return new ModelSet(name, files);
    }

    /** The same files but for one, which is new or has another text. */
    public ModelSet with(String path, String text) {
        TreeMap<String, Parsing> changed = new TreeMap<>(files);
        changed.put(path, new Parsing(path, text));
        return new ModelSet(name, changed);
    }

    ModelSet without(String path) {
        TreeMap<String, Parsing> changed = new TreeMap<>(files);
        changed.remove(path);
        return new ModelSet(name, changed);
    }

    public String text(String path) {
        return files.get(path).file().text();
    }

    /** What was done to another set: the files that are not the same. */
    String differenceFrom(ModelSet original) {
        StringBuilder text = new StringBuilder();
        for (Map.Entry<String, Parsing> file : files.entrySet()) {
            if (!file.getValue().equals(original.files.get(file.getKey()))) {
                text.append("==== ").append(file.getKey()).append('\n');
                text.append(file.getValue().file().text()).append('\n');
            }
        }
        for (String path : original.files.keySet()) {
            if (!files.containsKey(path)) {
                text.append("==== ").append(path).append(" is gone\n");
            }
        }
        return text.toString();
    }

    private static String read(Path file) {
        try {
            return Files.readString(file);
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
    }
}
