package arcomat.symbols;

import static org.assertj.core.api.Assertions.assertThat;

import arcomat.models.ModelFiles;
import arcomat.source.SourceFile;
import arcomat.syntax.Parsed;
import arcomat.syntax.Parser;
import arcomat.translate.HouseLanguages;
import arcomat.tree.Unit;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Set;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Stream;

/**
 * A test in one text: files behind lines {@code ==== path}, and last what is expected of them,
 * behind a line {@code ==== expected}. A path that ends in {@code (broken)} stands for a file that
 * did not parse.
 */
public record Scenario(Workspace workspace, String expected) {
    private static final Pattern HEADING = Pattern.compile("(?m)^==== (.*)$\\R?");

    public static List<Path> in(String folder) {
        try (Stream<Path> files = Files.list(Path.of("src/test/resources", folder))) {
            return files.filter(f -> f.toString().endsWith(".txt")).sorted().toList();
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
    }

    public static Scenario read(Path file) {
        try {
            return of(Files.readString(file));
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
    }

    public static Scenario of(String text) {
        List<Unit> units = new ArrayList<>();
        Set<String> broken = new HashSet<>();
        String expected = "";
        Matcher heading = HEADING.matcher(text);
        boolean more = heading.find();
        while (more) {
            String path = heading.group(1).strip();
            int start = heading.end();
            more = heading.find();
            String body = text.substring(start, more ? heading.start() : text.length());
            if (path.equals("expected")) {
                expected = body;
            } else if (path.endsWith(" (broken)")) {
                broken.add(path.substring(0, path.length() - " (broken)".length()));
            } else {
                units.add(parse(path, body));
            }
        }
        return new Scenario(Workspace.of(units, broken, HouseLanguages.reader()), expected);
    }

    /** The files of a folder with models, and what they need of the library. */
    public static Workspace models(String root) {
        List<Unit> units =
                ModelFiles.of(Path.of(root)).stream()
                        .map(file -> parse(file.path(), file.text()))
                        .toList();
        return Workspace.of(units, Set.of(), HouseLanguages.reader());
    }

    private static Unit parse(String path, String text) {
        Parsed parsed = Parser.parse(new SourceFile(path, text));
        assertThat(parsed.findings()).as(path).isEmpty();
        return parsed.unit().orElseThrow();
    }
}
