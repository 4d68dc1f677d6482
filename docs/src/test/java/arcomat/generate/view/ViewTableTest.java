package arcomat.generate.view;

import static org.assertj.core.api.Assertions.assertThat;

import arcomat.generate.language.TypeName;

import org.junit.jupiter.api.Test;

import java.io.IOException;
import java.lang.reflect.ParameterizedType;
import java.lang.reflect.RecordComponent;
import java.lang.reflect.Type;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Collectors;
import java.util.stream.Stream;

/**
 * The page about extensions has a table of all that templates see. {@code
 * -Dtranscripts.update=true} writes it anew, from the records and the first sentences about them.
 */
class ViewTableTest {
    private static final Path PAGE = Path.of("docs/extend.md");
    private static final Path SOURCES = Path.of("src/main/java/arcomat/generate/view");

    private static final Pattern TABLE =
            Pattern.compile(
                    "(?m)^\\| record \\| is \\| has \\|\n\\|---\\|---\\|---\\|\n((?:\\|.*\n)*)");

    /** A comment, its first sentence, and the record that it is about. */
    private static final Pattern RECORD =
            Pattern.compile("/\\*\\*((?:(?!\\*/)[\\s\\S])*)\\*/\\s*public record (\\w+)");

    @Test
    void theTableIsCurrent() throws IOException {
        String page = Files.readString(PAGE);
        Matcher table = TABLE.matcher(page);
        assertThat(table.find()).isTrue();
        String rows = rows();
        if (Boolean.getBoolean("transcripts.update")) {
            Files.writeString(
                    PAGE, page.substring(0, table.start(1)) + rows + page.substring(table.end(1)));
        }
        assertThat(table.group(1)).isEqualTo(rows);
    }

    private static String rows() throws IOException {
        Map<String, Class<?>> records = new TreeMap<>();
        Map<String, String> sentences = new TreeMap<>();
        try (Stream<Path> files = Files.list(SOURCES)) {
            for (Path file : files.filter(f -> f.toString().endsWith("View.java")).toList()) {
                String name = file.getFileName().toString().replace(".java", "");
                collect(loaded(name), records);
                RECORD.matcher(Files.readString(file))
                        .results()
                        .forEach(found -> sentences.put(found.group(2), sentence(found.group(1))));
            }
        }
        return records.entrySet().stream()
                .map(
                        each ->
                                "| `%s` | %s | %s |\n"
                                        .formatted(
                                                each.getKey(),
                                                sentences.get(each.getKey()),
                                                components(each.getValue())))
                .collect(Collectors.joining());
    }

    private static Class<?> loaded(String name) {
        try {
            return Class.forName(ViewTableTest.class.getPackageName() + "." + name);
        } catch (ClassNotFoundException e) {
            throw new AssertionError(e);
        }
    }

    private static void collect(Class<?> type, Map<String, Class<?>> records) {
        assertThat(records.put(type.getSimpleName(), type)).isNull();
        List.of(type.getDeclaredClasses()).forEach(inner -> collect(inner, records));
    }

    /** The first sentence of a comment, as plain text. */
    private static String sentence(String comment) {
        String text = comment.replaceAll("\\s*\n\\s*\\* ?", " ").strip();
        return text.replaceAll("(?s)(\\.) .*", "$1")
                .replaceAll("\\{@\\w+ (?:[\\w.#]+ )?([^}]*)}", "$1");
    }

    private static String components(Class<?> type) {
        return shown(type).map(ViewTableTest::component).collect(Collectors.joining(", "));
    }

    /** The words of a view's own name are its own. */
    private static Stream<RecordComponent> shown(Class<?> type) {
        return Arrays.stream(type.getRecordComponents())
                .flatMap(
                        each ->
                                each.getType() == TypeName.class
                                        ? shown(TypeName.class)
                                        : Stream.of(each));
    }

    private static String component(RecordComponent component) {
        String kind = kind(component.getGenericType());
        return "`" + component.getName() + "`" + (kind.isEmpty() ? "" : " " + kind);
    }

    /** Texts, numbers and truth values need no word. */
    private static String kind(Type type) {
        if (type instanceof ParameterizedType list) {
            String of = kind(list.getActualTypeArguments()[0]);
            return of.isEmpty() ? "list" : "list of " + of;
        }
        return type instanceof Class<?> named && named.isRecord() ? named.getSimpleName() : "";
    }
}
