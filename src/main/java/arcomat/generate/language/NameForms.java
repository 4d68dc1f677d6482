package arcomat.generate.language;

import java.util.Locale;

/** Names of models in the forms that languages want. */
public final class NameForms {
    private NameForms() {}

    /** {@code tooClose} as {@code TOO_CLOSE}, the form of named constants. */
    public static String constant(String name) {
        StringBuilder result = new StringBuilder();
        for (int i = 0; i < name.length(); i++) {
            char c = name.charAt(i);
            boolean starts = i > 0 && Character.isUpperCase(c) && startsWord(name, i);
            result.append(starts ? "_" : "").append(Character.toUpperCase(c));
        }
        return identifier(result.toString());
    }

    private static boolean startsWord(String name, int i) {
        char before = name.charAt(i - 1);
        boolean lowerFollows = i + 1 < name.length() && Character.isLowerCase(name.charAt(i + 1));
        return Character.isLowerCase(before)
                || Character.isDigit(before)
                || Character.isUpperCase(before) && lowerFollows;
    }

    public static String capitalised(String name) {
        return name.isEmpty() ? name : Character.toUpperCase(name.charAt(0)) + name.substring(1);
    }

    public static String uncapitalised(String name) {
        return name.isEmpty()
                ? name
                : name.substring(0, 1).toLowerCase(Locale.ROOT) + name.substring(1);
    }

    /**
     * The name of a component as one identifier: {@code Outer.Inner} as {@code Outer_Inner}, {@code
     * Buffer<Integer[0..5]>} as {@code BufferOfInteger_0_5}.
     */
    public static String type(String name) {
        StringBuilder result = new StringBuilder();
        boolean separated = false;
        for (char c : name.replace("<", "Of ").replace(">", "").toCharArray()) {
            if (Character.isJavaIdentifierPart(c)) {
                result.append(separated ? separator(result, c) : "").append(c);
                separated = false;
            } else {
                separated = true;
            }
        }
        return identifier(result.toString());
    }

    private static String separator(StringBuilder before, char next) {
        boolean ofArgument = before.toString().endsWith("Of") && Character.isLetter(next);
        return ofArgument ? "" : "_";
    }

    /** Replaces what cannot stand in an identifier; {@code wheel[0]} is {@code wheel_0}. */
    public static String identifier(String name) {
        String clean = name.replace("]", "").replaceAll("[^\\p{L}\\p{Nd}_$]", "_");
        return clean.isEmpty() || !Character.isJavaIdentifierStart(clean.charAt(0))
                ? "_" + clean
                : clean;
    }
}
