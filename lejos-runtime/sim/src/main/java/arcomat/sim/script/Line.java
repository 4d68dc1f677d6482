package arcomat.sim.script;

import java.util.Arrays;
import java.util.List;

/** The words of one line, read from left to right. */
final class Line {
    private final List<Word> words;
    private int position;

    /**
     * @param words at least one
     */
    Line(List<Word> words) {
        this.words = words;
    }

    boolean hasNext() {
        return position < words.size();
    }

    Word next(String expected) throws BrokenLine {
        if (!hasNext()) {
            throw words.get(words.size() - 1).after().broken("here should follow " + expected);
        }
        return words.get(position++);
    }

    int number(String meaning, int low, int high) throws BrokenLine {
        Word word = next("%s, %d to %d".formatted(meaning, low, high));
        try {
            int number = Integer.parseInt(word.text());
            if (number >= low && number <= high) {
                return number;
            }
        } catch (NumberFormatException e) {
            // told below, like a number that is out of range
        }
        throw word.broken("'%s' is not %s, %d to %d".formatted(word.text(), meaning, low, high));
    }

    <E extends Enum<E>> E constant(Class<E> type, String meaning) throws BrokenLine {
        List<String> names = Arrays.stream(type.getEnumConstants()).map(Enum::name).toList();
        String expected = "%s: %s".formatted(meaning, String.join(", ", names));
        Word word = next(expected);
        if (!names.contains(word.text())) {
            throw word.broken("'%s' is not %s".formatted(word.text(), expected));
        }
        return Enum.valueOf(type, word.text());
    }

    void end() throws BrokenLine {
        if (hasNext()) {
            Word word = words.get(position);
            throw word.broken("'%s' is one word too many".formatted(word.text()));
        }
    }
}
