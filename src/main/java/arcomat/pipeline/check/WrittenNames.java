package arcomat.pipeline.check;

import java.util.LinkedHashSet;
import java.util.Set;

/** Every name in a text, in comments and literals, too, in the order of the text. */
public final class WrittenNames {
    private WrittenNames() {}

    public static Set<String> in(String text) {
        Set<String> names = new LinkedHashSet<>();
        int at = 0;
        while (at < text.length()) {
            int end = at;
            while (end < text.length() && isPart(text.codePointAt(end), end > at)) {
                end += Character.charCount(text.codePointAt(end));
            }
            if (end > at) {
                names.add(text.substring(at, end));
                at = end;
            } else {
                at += Character.charCount(text.codePointAt(at));
            }
        }
        return names;
    }

    private static boolean isPart(int c, boolean inside) {
        return Character.isLetter(c) || c == '_' || c == '$' || inside && isNumber(c);
    }

    private static boolean isNumber(int c) {
        int type = Character.getType(c);
        return type == Character.DECIMAL_DIGIT_NUMBER
                || type == Character.LETTER_NUMBER
                || type == Character.OTHER_NUMBER;
    }
}
