package arcomat.generate.language;

import java.util.Map;
import java.util.regex.Matcher;

/**
 * One line of a target's expression table: {@code 12 | {0:12} * {1:13}} says that the text binds at
 * level 12, that its first operand has to bind at least as tightly and the second more tightly.
 * {@code {0}} takes any operand as it is, {@code {name}} a named piece of text. A line without a
 * level gives a text that never needs parentheses.
 */
record Pattern(int level, String form) {
    private static final java.util.regex.Pattern PLACE =
            java.util.regex.Pattern.compile("\\{([A-Za-z_]\\w*|\\d{1,4})(?::(\\d{1,4}))?}");
    private static final java.util.regex.Pattern LINE =
            java.util.regex.Pattern.compile(
                    "(\\d{1,4})\\s*\\|\\s+(.*)", java.util.regex.Pattern.DOTALL);

    static Pattern parse(String line) {
        Matcher matcher = LINE.matcher(line);
        return matcher.matches()
                ? new Pattern(Integer.parseInt(matcher.group(1)), matcher.group(2))
                : new Pattern(Text.PRIMARY, line);
    }

    /** Fills the places; a place with nothing to fill it stays as it is. */
    Text fill(Map<String, String> names, Text... operands) {
        StringBuilder filled = new StringBuilder();
        Matcher place = PLACE.matcher(form);
        while (place.find()) {
            place.appendReplacement(
                    filled, Matcher.quoteReplacement(content(place, names, operands)));
        }
        return new Text(place.appendTail(filled).toString(), level);
    }

    private static String content(Matcher place, Map<String, String> names, Text... operands) {
        String name = place.group(1);
        if (!Character.isDigit(name.charAt(0))) {
            return names.getOrDefault(name, place.group());
        }
        int index = Integer.parseInt(name);
        if (index >= operands.length) {
            return place.group();
        }
        int wanted = place.group(2) == null ? 0 : Integer.parseInt(place.group(2));
        return operands[index].atLevel(wanted);
    }
}
