package arcomat.source;

import java.util.Locale;
import java.util.Map;

/** Characters that cannot be seen, or look like others, and how messages show them. */
public final class Signs {
    private static final Map<Integer, String> BLANKS =
            Map.ofEntries(
                    Map.entry(0x000B, "vertical tab"),
                    Map.entry(0x0085, "next line"),
                    Map.entry(0x00A0, "no-break space"),
                    Map.entry(0x1680, "ogham space mark"),
                    Map.entry(0x2000, "en quad"),
                    Map.entry(0x2001, "em quad"),
                    Map.entry(0x2002, "en space"),
                    Map.entry(0x2003, "em space"),
                    Map.entry(0x2004, "three-per-em space"),
                    Map.entry(0x2005, "four-per-em space"),
                    Map.entry(0x2006, "six-per-em space"),
                    Map.entry(0x2007, "figure space"),
                    Map.entry(0x2008, "punctuation space"),
                    Map.entry(0x2009, "thin space"),
                    Map.entry(0x200A, "hair space"),
                    Map.entry(0x2028, "line separator"),
                    Map.entry(0x2029, "paragraph separator"),
                    Map.entry(0x202F, "narrow no-break space"),
                    Map.entry(0x205F, "medium mathematical space"),
                    Map.entry(0x2800, "braille pattern blank"),
                    Map.entry(0x3000, "ideographic space"),
                    Map.entry(0x3164, "hangul filler"));

    private static final Map<Integer, String> UNSEEN =
            Map.ofEntries(
                    Map.entry(0x00AD, "soft hyphen"),
                    Map.entry(0x180E, "mongolian vowel separator"),
                    Map.entry(0x200B, "zero width space"),
                    Map.entry(0x200C, "zero width non-joiner"),
                    Map.entry(0x200D, "zero width joiner"),
                    Map.entry(0x200E, "left-to-right mark"),
                    Map.entry(0x200F, "right-to-left mark"),
                    Map.entry(0x202A, "left-to-right embedding"),
                    Map.entry(0x202B, "right-to-left embedding"),
                    Map.entry(0x202C, "pop directional formatting"),
                    Map.entry(0x202D, "left-to-right override"),
                    Map.entry(0x202E, "right-to-left override"),
                    Map.entry(0x2060, "word joiner"),
                    Map.entry(0x2066, "left-to-right isolate"),
                    Map.entry(0x2067, "right-to-left isolate"),
                    Map.entry(0x2068, "first strong isolate"),
                    Map.entry(0x2069, "pop directional isolate"),
                    Map.entry(0xFEFF, "byte order mark"));

    private Signs() {}

    /** Whether it looks like a space, and is none. */
    public static boolean isBlank(int sign) {
        return BLANKS.containsKey(sign);
    }

    /** Whether nothing is seen of it. */
    public static boolean isUnseen(int sign) {
        return UNSEEN.containsKey(sign);
    }

    /** Whether it changes the order in which a line is shown, so that it reads as another one. */
    public static boolean changesDirection(int sign) {
        return sign >= 0x202A && sign <= 0x202E || sign >= 0x2066 && sign <= 0x2069;
    }

    /** In quotes; what is not seen as it is, by its number and its name. */
    public static String quoted(int sign) {
        String name = BLANKS.getOrDefault(sign, UNSEEN.getOrDefault(sign, otherName(sign)));
        return name.isEmpty()
                ? "'" + new String(Character.toChars(sign)) + "'"
                : "'" + escaped(new String(Character.toChars(sign))) + "' (" + name + ")";
    }

    private static String otherName(int sign) {
        return switch (Character.getType(sign)) {
            case Character.NON_SPACING_MARK, Character.ENCLOSING_MARK -> "combining mark";
            case Character.CONTROL, Character.FORMAT -> "control character";
            case Character.SURROGATE -> "half of a character";
            case Character.PRIVATE_USE, Character.UNASSIGNED -> "no character of Unicode";
            default -> "";
        };
    }

    private static String escaped(String text) {
        StringBuilder escaped = new StringBuilder();
        text.chars().forEach(unit -> escaped.append(escape(unit)));
        return escaped.toString();
    }

    private static String escape(int unit) {
        return String.format(Locale.ROOT, "\\u%04x", unit);
    }

    /** A text with escapes, as Java writes them, for what changes the direction. */
    public static String withoutDirections(String text) {
        if (text.chars().noneMatch(Signs::changesDirection)) {
            return text;
        }
        StringBuilder result = new StringBuilder();
        text.chars()
                .forEach(
                        unit ->
                                result.append(
                                        changesDirection(unit)
                                                ? escape(unit)
                                                : String.valueOf((char) unit)));
        return result.toString();
    }
}
