package arcomat.pipeline.recheck;

import arcomat.check.DataFile;
import arcomat.source.SourceFile;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Random;
import java.util.SortedSet;
import java.util.TreeSet;
import java.util.regex.MatchResult;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Stream;

/** A folder of models that somebody edits without a plan. */
final class EditedModels {
    private static final Path DATA = Path.of("src/test/resources/check");
    private static final Path NEIGHBOURS = Path.of("src/test/resources/incremental");
    private static final int NUMBER_OF_NEIGHBOURS = 5;
    private static final Pattern WORD = Pattern.compile("[A-Za-z]\\w*");
    private static final List<List<Model>> FAMILIES = families();
    private static final List<Model> POOL = FAMILIES.stream().flatMap(List::stream).toList();

    private final Path folder;
    private final Random random;
    private final SortedSet<String> paths = new TreeSet<>();

    private record Model(String path, String text) {
        /**
         * Without the comments that say what to expect: they would mention what they do not use.
         */
        static Model of(SourceFile file) {
            return new Model(file.path(), file.text().replaceAll("(?m)^//.*\n?", ""));
        }
    }

    int size() {
        return paths.size();
    }

    EditedModels(Path folder, Random random) {
        this.folder = folder;
        this.random = random;
    }

    /**
     * The models of every law's test, and those of files that need one another by several steps.
     */
    private static List<List<Model>> families() {
        List<List<Model>> families = new ArrayList<>();
        for (Path data : List.of(DATA, NEIGHBOURS)) {
            try (Stream<Path> files = Files.walk(data)) {
                for (Path file : files.filter(Files::isRegularFile).sorted().toList()) {
                    if (file.toString().endsWith(".arc")) {
                        families.add(DataFile.read(file).files().stream().map(Model::of).toList());
                    }
                }
            } catch (IOException e) {
                throw new UncheckedIOException(e);
            }
        }
        return families;
    }

    /** Models that belong together, perhaps in the place of others. */
    String add() {
        boolean neighbours = random.nextInt(3) == 0;
        int first = neighbours ? FAMILIES.size() - NUMBER_OF_NEIGHBOURS : 0;
        List<Model> family = FAMILIES.get(first + random.nextInt(FAMILIES.size() - first));
        family.forEach(model -> write(model.path(), model.text()));
        return "add " + family.stream().map(Model::path).toList();
    }

    /** Returns what was done. */
    String edit() {
        if (paths.size() < 10) {
            return add();
        }
        String path = List.copyOf(paths).get(random.nextInt(paths.size()));
        switch (random.nextInt(10)) {
            case 0:
                return add();
            case 1:
                remove(path);
                return "remove " + path;
            case 2:
                return rename(path);
            case 3:
                write(path, cut(read(path)));
                return "cut " + path;
            case 4:
                write(path, "\n" + read(path));
                return "shift " + path;
            case 5:
                write(path, "\0" + read(path));
                return "spoil " + path;
            case 6:
            case 7:
                return repair(path);
            default:
                write(path, exchangeWord(read(path)));
                return "change " + path;
        }
    }

    private String rename(String path) {
        String text = read(path);
        String name = path.substring(path.lastIndexOf('/') + 1);
        String other =
                switch (random.nextInt(4)) {
                    case 0 -> path.toLowerCase(Locale.ROOT);
                    case 1 -> "p/" + name;
                    case 2 -> "nxt/" + name;
                    default -> "q/r/" + name;
                };
        remove(path);
        write(other, text);
        return "rename " + path + " to " + other;
    }

    /** Some model of that path; else any. */
    private String repair(String path) {
        List<Model> fitting = POOL.stream().filter(each -> each.path().equals(path)).toList();
        if (fitting.isEmpty()) {
            return add();
        }
        write(path, fitting.get(random.nextInt(fitting.size())).text());
        return "repair " + path;
    }

    private String cut(String text) {
        int start = random.nextInt(text.length() + 1);
        int end = Math.min(text.length(), start + 1 + random.nextInt(20));
        return text.substring(0, start) + text.substring(end);
    }

    /** A word of the text becomes another one, mostly of a text beside it. */
    private String exchangeWord(String text) {
        List<MatchResult> words = words(text);
        String beside = List.copyOf(paths).get(random.nextInt(paths.size()));
        List<MatchResult> others =
                words(
                        random.nextInt(4) == 0
                                ? POOL.get(random.nextInt(POOL.size())).text()
                                : read(beside));
        if (words.isEmpty() || others.isEmpty()) {
            return text + "\n";
        }
        MatchResult word = words.get(random.nextInt(words.size()));
        String other = others.get(random.nextInt(others.size())).group();
        return text.substring(0, word.start()) + other + text.substring(word.end());
    }

    private static List<MatchResult> words(String text) {
        Matcher matcher = WORD.matcher(text);
        return matcher.results().toList();
    }

    private String read(String path) {
        try {
            return Files.readString(folder.resolve(path));
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
    }

    private void write(String path, String text) {
        try {
            Files.createDirectories(folder.resolve(path).getParent());
            Files.writeString(folder.resolve(path), text);
            paths.add(path);
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
    }

    private void remove(String path) {
        try {
            Files.delete(folder.resolve(path));
            paths.remove(path);
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
    }
}
