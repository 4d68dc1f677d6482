package arcomat.analysis.search.encoding;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.OptionalInt;
import java.util.Set;
import java.util.stream.Collectors;
import java.util.stream.IntStream;

/**
 * What the bits of a state are, in words, and back. What two bits would be called has no meaning.
 */
public final class StateWords {
    private static final String NOT = "not ";
    private static final int MOST_NAMED = 20;

    /** What stands between a part or a signal and what is said of it. */
    private static final List<String> SAYING = List.of(": ", " = ", " may be in ");

    /** By position. */
    private final List<Word> states;

    /** By position; there may be further inputs, which choose. */
    private final List<String> inputs;

    private final Map<String, Integer> literals = new HashMap<>();

    /**
     * @param text what is so where a bit is true
     * @param contrary what is so where it is not
     * @param certain whether it is always true, so that it need not be told
     * @param possible whether it may be true
     */
    private record Word(String text, String contrary, boolean certain, boolean possible) {}

    private StateWords(List<Word> states, List<String> inputs) {
        this.states = List.copyOf(states);
        this.inputs = List.copyOf(inputs);
        Set<String> ambiguous = new HashSet<>();
        for (int i = 0; i < states.size(); i++) {
            name(states.get(i).text, i + 1, ambiguous);
            name(NOT + states.get(i).text, -i - 1, ambiguous);
        }
        literals.keySet().removeAll(ambiguous);
    }

    /** Bit by bit. */
    static final class Collector {
        private final List<Word> words = new ArrayList<>();

        /** Which do not depend on each other; one that is alone is true. */
        void each(List<String> texts) {
            texts.forEach(text -> words.add(new Word(text, NOT + text, texts.size() == 1, true)));
        }

        /**
         * Of which exactly one is true: where there are two, the other one is the contrary.
         *
         * @param possible whether one may be true at all
         */
        void alternatives(List<String> texts, List<Boolean> possible) {
            List<String> all =
                    IntStream.range(0, texts.size())
                            .filter(possible::get)
                            .mapToObj(texts::get)
                            .toList();
            for (int i = 0; i < texts.size(); i++) {
                String text = texts.get(i);
                boolean isOne = possible.get(i);
                String contrary =
                        isOne && all.size() == 2 ? all.get(1 - all.indexOf(text)) : NOT + text;
                words.add(new Word(text, contrary, isOne && all.size() == 1, isOne));
            }
        }

        /**
         * @param inputs what comes from outside where a bit is true
         */
        StateWords words(List<String> inputs) {
            return new StateWords(words, inputs);
        }
    }

    private void name(String word, int literal, Set<String> ambiguous) {
        if (literals.put(word, literal) != null) {
            ambiguous.add(word);
        }
    }

    /** A literal that counts bits from 1 on, in words. */
    public String of(int literal) {
        return literal > 0 ? states.get(literal - 1).text : states.get(-literal - 1).contrary;
    }

    /** The literal that is called so; empty where none is. */
    public OptionalInt literal(String word) {
        Integer literal = literals.get(word);
        return literal == null ? OptionalInt.empty() : OptionalInt.of(literal);
    }

    /** What else may be said of the same part or signal, as far as there is something. */
    public List<String> others(String word) {
        String plain = word.startsWith(NOT) ? word.substring(NOT.length()) : word;
        int end = SAYING.stream().mapToInt(plain::indexOf).filter(i -> i >= 0).min().orElse(-1);
        return end < 0
                ? List.of()
                : states.stream()
                        .filter(Word::possible)
                        .map(Word::text)
                        .filter(each -> isAbout(each, plain.substring(0, end)))
                        .limit(MOST_NAMED)
                        .toList();
    }

    private static boolean isAbout(String text, String about) {
        return SAYING.stream().anyMatch(saying -> text.startsWith(about + saying));
    }

    /** All that is so in a state, but for what always is. */
    public String state(boolean[] truths) {
        return told(
                IntStream.range(0, states.size())
                        .filter(i -> truths[i] && !states.get(i).certain)
                        .mapToObj(i -> states.get(i).text)
                        .toList());
    }

    /** What comes from outside. */
    public String input(boolean[] truths) {
        return told(
                IntStream.range(0, inputs.size())
                        .filter(i -> truths[i])
                        .mapToObj(inputs::get)
                        .toList());
    }

    private static String told(List<String> all) {
        String named = all.stream().limit(MOST_NAMED).collect(Collectors.joining(", "));
        int others = all.size() - MOST_NAMED;
        return others > 0 ? named + " and %d more".formatted(others) : named;
    }
}
