package arcomat.generate.language;

import arcomat.model.Type;

import java.util.HashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.Set;

/**
 * How a target's language spells types, literals and operators: the entries of {@code
 * target.properties}. An entry may have a variant per kind of type, {@code equal.string} beside
 * {@code equal}.
 */
public final class TargetLanguage {
    private static final String EXPRESSION = "expression.";

    private final Map<String, String> entries;
    private final Map<String, Pattern> patterns = new HashMap<>();
    private final Set<String> reserved;

    public TargetLanguage(Map<String, String> entries) {
        this.entries = Map.copyOf(entries);
        this.reserved = Set.copyOf(List.of(words("reserved"))); // some may be named twice
        entries.forEach((key, line) -> patterns.put(key, Pattern.parse(line)));
    }

    /** Words that cannot be names. */
    public Set<String> reserved() {
        return reserved;
    }

    /**
     * Names that are neither reserved words nor taken already.
     *
     * @param lists entries with further words that are taken
     */
    public UniqueNames unreserved(String... lists) {
        UniqueNames free = UniqueNames.of(reserved);
        for (String list : lists) {
            for (String word : words(list)) {
                free.claim(word);
            }
        }
        return free;
    }

    public Optional<String> entry(String key) {
        return Optional.ofNullable(entries.get(key));
    }

    /** A list of words, empty where the entry is missing. */
    public String[] words(String key) {
        String line = entries.getOrDefault(key, "").strip();
        return line.isEmpty() ? new String[0] : line.split("\\s+");
    }

    /**
     * Fills in an entry of the expression table.
     *
     * @param type decides between variants
     * @throws MissingEntry where the table has none
     */
    public Text express(String key, Type type, Map<String, String> names, Text... operands) {
        Pattern pattern = patterns.get(EXPRESSION + key + "." + kind(type));
        if (pattern == null) {
            pattern = patterns.get(EXPRESSION + key);
        }
        if (pattern == null) {
            throw new MissingEntry(EXPRESSION + key + " (or ." + kind(type) + ")");
        }
        return pattern.fill(names, operands);
    }

    /** The spelling of an entry that has named places only. */
    public String spell(String key, Map<String, String> names) {
        Pattern pattern = patterns.get(key);
        if (pattern == null) {
            throw new MissingEntry(key);
        }
        return pattern.fill(names).text();
    }

    /** The name of the flag that says whether a port carries a message. */
    public String flag(String port) {
        return spell("flag", Map.of("port", port, "Port", NameForms.capitalised(port)));
    }

    /**
     * Whether the class of Java that a type stands for is named; else there is one in its stead.
     */
    public boolean namesJava(Type type) {
        return type instanceof Type.ClassType object
                && object.java().isPresent()
                && entry("java").filter("named"::equals).isPresent();
    }

    /** The name of a type's kind in the description of a target. */
    public String kind(Type type) {
        return namesJava(type) ? "java" : type.match(new Kind());
    }

    private static final class Kind implements Type.Cases<String> {
        @Override
        public String booleanType(Type.BooleanType type) {
            return "boolean";
        }

        @Override
        public String integerType(Type.IntegerType type) {
            return type.width().name().toLowerCase(Locale.ROOT);
        }

        @Override
        public String realType(Type.RealType type) {
            return type.single() ? "float" : "double";
        }

        @Override
        public String characterType(Type.CharacterType type) {
            return "char";
        }

        @Override
        public String stringType(Type.StringType type) {
            return "string";
        }

        @Override
        public String enumType(Type.EnumType type) {
            return "enum";
        }

        @Override
        public String classType(Type.ClassType type) {
            return "class";
        }
    }

    /** The description of the target lacks an entry that the model needs. */
    public static final class MissingEntry extends RuntimeException {
        private static final long serialVersionUID = 1L;

        MissingEntry(String key) {
            super(key);
        }
    }
}
