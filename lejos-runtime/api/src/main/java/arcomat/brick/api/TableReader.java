package arcomat.brick.api;

import org.objectweb.asm.Opcodes;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;

/**
 * Reads the table: a line per class, followed by lines for its nesting, fields and methods; words
 * are separated by tabs, {@code -} stands for nothing.
 */
final class TableReader {
    private final List<BrickType> types = new ArrayList<>();
    private String[] head = {};
    private Optional<BrickType.Nesting> nesting = Optional.empty();
    private List<BrickField> fields = new ArrayList<>();
    private List<BrickMethod> methods = new ArrayList<>();

    private TableReader() {}

    /**
     * @throws IllegalArgumentException where a line is none of the table's, with its number
     */
    static BrickTable read(String text) {
        TableReader reader = new TableReader();
        int number = 0;
        for (String line : text.lines().toList()) {
            number++;
            try {
                reader.line(line.split("\t", -1));
            } catch (RuntimeException e) {
                throw new IllegalArgumentException("line " + number + ": " + e.getMessage(), e);
            }
        }
        reader.finishType();
        return new BrickTable(reader.types);
    }

    private void line(String[] words) {
        switch (words[0]) {
            case "class" -> {
                finishType();
                head = words;
            }
            case "inner" -> nesting = Optional.of(nesting(words));
            case "field" -> fields.add(field(words));
            case "method" -> methods.add(method(words));
            default -> throw new IllegalArgumentException("unknown kind " + words[0]);
        }
    }

    private void finishType() {
        if (head.length == 0) {
            return;
        }
        types.add(
                new BrickType(
                        head[1],
                        typeAccess(),
                        Optional.of(head[3]).filter(name -> !name.equals("null")),
                        names(head[4]),
                        optional(head[5]),
                        nesting,
                        fields,
                        methods));
        nesting = Optional.empty();
        fields = new ArrayList<>();
        methods = new ArrayList<>();
    }

    /** The table leaves out that an interface is an annotation; its supertype tells. */
    private int typeAccess() {
        boolean isAnnotation = names(head[4]).contains("java/lang/annotation/Annotation");
        return AccessFlags.parse(head[2]) | (isAnnotation ? Opcodes.ACC_ANNOTATION : 0);
    }

    private static BrickType.Nesting nesting(String[] words) {
        return new BrickType.Nesting(words[1], words[2], AccessFlags.parse(words[3]));
    }

    private static BrickField field(String[] words) {
        return new BrickField(
                words[1],
                AccessFlags.parse(words[2]),
                words[3],
                optional(words[4]),
                optional(words[5]).map(value -> constant(words[3], value)));
    }

    private static Object constant(String descriptor, String value) {
        return switch (descriptor) {
            case "B", "C", "I", "S" -> Integer.valueOf(value);
            case "J" -> Long.valueOf(value);
            case "F" -> Float.valueOf(value);
            case "D" -> Double.valueOf(value);
            default -> throw new IllegalArgumentException("constant of type " + descriptor);
        };
    }

    private static BrickMethod method(String[] words) {
        return new BrickMethod(
                words[1],
                AccessFlags.parse(words[2]),
                words[3],
                optional(words[4]),
                names(words[5]));
    }

    private static Optional<String> optional(String word) {
        return word.equals("-") ? Optional.empty() : Optional.of(word);
    }

    private static List<String> names(String word) {
        return word.equals("-") ? List.of() : Arrays.asList(word.split(","));
    }
}
