package arcomat.table;

import java.util.ArrayList;
import java.util.List;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Collectors;

/**
 * A piece of a table's text.
 *
 * @param tokens of it; comments and blanks are none
 */
record Part(List<Token> tokens) {
    /**
     * Words and signs as far as a table has to tell them apart. Beyond ASCII all is a letter:
     * browsers have no names for classes of characters here.
     */
    private static final Pattern TOKEN =
            Pattern.compile(
                    "(\\s+|//[^\\n]*|/\\*(?s:.*?)\\*/)"
                            + "|\"[^\"\\\\]*+(?:\\\\.[^\"\\\\]*+)*+\""
                            + "|'[^'\\\\]*+(?:\\\\.[^'\\\\]*+)*+'"
                            + "|<=>|=>|\\|\\||==|<=|>=|!=|--"
                            + "|[A-Za-z0-9_$\\u0080-\\uffff]+"
                            + "|(?s:.)");

    /** A word or a sign, by offsets in the text. */
    record Token(String text, int start, int end) {}

    Part {
        tokens = List.copyOf(tokens);
    }

    static Part of(String text) {
        List<Token> tokens = new ArrayList<>();
        Matcher matcher = TOKEN.matcher(text);
        while (matcher.find()) {
            if (matcher.group(1) == null) {
                tokens.add(new Token(matcher.group(), matcher.start(), matcher.end()));
            }
        }
        return new Part(tokens);
    }

    int start() {
        return tokens.get(0).start();
    }

    int end() {
        return tokens.get(tokens.size() - 1).end();
    }

    /** Without blanks and comments. */
    String text() {
        return tokens.stream().map(Token::text).collect(Collectors.joining());
    }

    boolean beginsWith(String... words) {
        return tokens.stream().limit(words.length).map(Token::text).toList().equals(List.of(words));
    }

    /** Without the first tokens. */
    Part behind(int first) {
        return new Part(tokens.subList(first, tokens.size()));
    }

    /** What stands between the brackets that it ends with. */
    Part inBrackets(int open) {
        return new Part(tokens.subList(open + 1, tokens.size() - 1));
    }

    /** What lies between separators that stand in no brackets; nothing where nothing lies. */
    List<Part> split(String separator) {
        List<Part> parts = new ArrayList<>();
        int depth = 0;
        int start = 0;
        for (int i = 0; i < tokens.size(); i++) {
            String text = tokens.get(i).text();
            depth += depthOf(text);
            if (depth == 0 && text.equals(separator)) {
                add(start, i, parts);
                start = i + 1;
            }
        }
        add(start, tokens.size(), parts);
        return parts;
    }

    private void add(int start, int end, List<Part> parts) {
        if (start < end) {
            parts.add(new Part(tokens.subList(start, end)));
        }
    }

    private static int depthOf(String token) {
        return switch (token) {
            case "(", "[", "{" -> 1;
            case ")", "]", "}" -> -1;
            default -> 0;
        };
    }

    boolean isAnything() {
        return text().equals("*");
    }

    boolean isAlternatives() {
        return beginsWith("alt", "{");
    }

    /** Whether it is a list of several messages, or one of its alternatives is. */
    boolean isList() {
        return isAlternatives()
                ? inBrackets(1).split(",").stream().anyMatch(Part::isList)
                : beginsWith("[") && inBrackets(0).split(",").size() > 1;
    }
}
