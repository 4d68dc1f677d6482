package montiarc7.source;

import java.util.HashMap;
import java.util.Map;
import java.util.Optional;
import java.util.regex.Matcher;
import java.util.regex.Pattern;

/**
 * A class of a class diagram.
 *
 * @param parent the simple name of the class that it extends; empty for none
 * @param attributes their types, as they are written
 */
record ClassText(String parent, Map<String, String> attributes) {
    private static final Pattern CLASS =
            Pattern.compile(
                    "\\bclass\\s+(\\w+)\\s*(?:extends\\s+([\\w.]+))?[^{};<>]*\\{([^{}]*)\\}");
    private static final Pattern ATTRIBUTE =
            Pattern.compile(
                    "(?:public|protected|final|\\+|#|\\s)*([\\w.]+)\\s+(\\w+)\\s*(?:=[^()]*)?");

    /** Those of a diagram, without comments, by their names. */
    static Map<String, ClassText> of(String diagram) {
        Map<String, ClassText> all = new HashMap<>();
        Matcher found = CLASS.matcher(diagram);
        while (found.find()) {
            Map<String, String> attributes = new HashMap<>();
            for (String each : found.group(3).split(";")) {
                Matcher attribute = ATTRIBUTE.matcher(each);
                if (attribute.matches()) {
                    attributes.put(attribute.group(2), attribute.group(1));
                }
            }
            String parent = Optional.ofNullable(found.group(2)).orElse("");
            all.put(found.group(1), new ClassText(simple(parent), attributes));
        }
        return all;
    }

    static String simple(String name) {
        return name.substring(name.lastIndexOf('.') + 1);
    }
}
