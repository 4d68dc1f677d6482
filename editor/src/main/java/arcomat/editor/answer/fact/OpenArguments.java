package arcomat.editor.answer.fact;

import java.util.ArrayDeque;
import java.util.Deque;
import java.util.List;
import java.util.Optional;

/**
 * A list of arguments that is being written.
 *
 * @param before the words in front of its parenthesis
 * @param position how many arguments are complete
 */
record OpenArguments(List<String> before, int position) {

    /** The innermost list at the end that has a name in front of it; empty where there is none. */
    static Optional<OpenArguments> at(List<String> words) {
        Deque<Integer> open = new ArrayDeque<>();
        for (int i = 0; i < words.size(); i++) {
            if (isOpening(words.get(i))) {
                open.push(i);
            } else if (isClosing(words.get(i)) && !open.isEmpty()) {
                open.pop();
            }
        }
        return open.stream()
                .filter(at -> words.get(at).equals("("))
                .map(at -> new OpenArguments(words.subList(0, at), commas(words, at)))
                .filter(each -> !each.name().isEmpty())
                .findFirst();
    }

    private static boolean isOpening(String word) {
        return word.equals("(") || word.equals("[") || word.equals("{");
    }

    private static boolean isClosing(String word) {
        return word.equals(")") || word.equals("]") || word.equals("}");
    }

    private static int commas(List<String> words, int open) {
        int depth = 0;
        int commas = 0;
        for (String word : words.subList(open + 1, words.size())) {
            depth += isOpening(word) ? 1 : 0;
            depth -= isClosing(word) ? 1 : 0;
            commas += depth == 0 && word.equals(",") ? 1 : 0;
        }
        return commas;
    }

    /** The name in front of the parenthesis, without arguments of a type; its words in a list. */
    List<String> name() {
        int end = beforeTypeArguments();
        int start = end;
        while (start > 0 && isNamePart(start - 1, end)) {
            start--;
        }
        return before.subList(start, end).stream().filter(word -> !word.equals(".")).toList();
    }

    /** A name, then a dot, then a name, from the end on. */
    private boolean isNamePart(int at, int end) {
        boolean isDot = before.get(at).equals(".");
        boolean isWord = Character.isJavaIdentifierStart(before.get(at).charAt(0));
        return (end - at) % 2 == 0 ? isDot : isWord;
    }

    private int beforeTypeArguments() {
        if (before.isEmpty() || !before.get(before.size() - 1).equals(">")) {
            return before.size();
        }
        int depth = 0;
        for (int i = before.size() - 1; i >= 0; i--) {
            depth += before.get(i).equals(">") ? 1 : 0;
            depth -= before.get(i).equals("<") ? 1 : 0;
            if (depth == 0) {
                return i;
            }
        }
        return before.size();
    }
}
