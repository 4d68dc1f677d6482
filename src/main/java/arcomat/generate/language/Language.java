package arcomat.generate.language;

import arcomat.model.Type;

import java.util.LinkedHashMap;
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
public final class Language {
    private final Map<String, String> entries;
    private final Map<String, Pattern> patterns = new LinkedHashMap<>();
    private final Set<String> reserved;

    public Language(Map<String, String> entries) {
        this.entries = Map.copyOf(entries);
        this.reserved = Set.copyOf(List.of(words("reserved"))); // some may be named twice
        entries.forEach(
                (key, line) -> {
                    if (key.startsWith("expression.")) {
                        patterns.put(key.substring("expression.".length()), Pattern.parse(line));
                    }
                });
    }

    /** Words that cannot be names. */
    public Set<String> reserved() {
        return reserved;
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
    public Text express(String key, Type type, Map<String, String> names, List<Text> operands) {
        Pattern pattern = patterns.get(key + "." + kind(type));
        if (pattern == null) {
            pattern = patterns.get(key);
        }
        if (pattern == null) {
            throw new MissingEntry("expression." + key + " (or ." + kind(type) + ")");
        }
        return pattern.fill(names, operands);
    }

    /** The spelling of an entry that has named places only. */
    public String spell(String key, Map<String, String> names) {
        String line = entries.get(key);
        if (line == null) {
            throw new MissingEntry(key);
        }
        return Pattern.parse(line).fill(names, List.of()).text();
    }

    /** The name of the flag that says whether a port carries a message. */
    public String spellFlag(String port, String capitalised) {
        return spell("flag", Map.of("port", port, "Port", capitalised));
    }

    /** The name of a type's kind in the description of a target. */
    public static String kind(Type type) {
        if (type instanceof Type.IntegerType integer) {
            return integer.width().name().toLowerCase(Locale.ROOT);
        }
        if (type instanceof Type.RealType real) {
            return real.single() ? "float" : "double";
        }
        if (type instanceof Type.BooleanType) {
            return "boolean";
        }
        if (type instanceof Type.CharacterType) {
            return "char";
        }
        if (type instanceof Type.StringType) {
            return "string";
        }
        return type instanceof Type.EnumType ? "enum" : "class";
    }

    /** The description of the target lacks an entry that the model needs. */
    public static final class MissingEntry extends RuntimeException {
        private static final long serialVersionUID = 1L;

        MissingEntry(String key) {
            super(key);
        }
    }
}
