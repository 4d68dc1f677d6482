package arcomat.guest;

import arcomat.source.Span;
import arcomat.tree.Name;

import java.util.List;
import java.util.Map;
import java.util.Optional;

/**
 * A language in which components say what they do: a word, perhaps a name, and a text in braces
 * that balance. What stands between them is the guest's: it says what that means in Arcomat's own
 * words, and everything behind, from laws to code, works with those.
 */
public interface BehaviourLanguage {
    /** What the behaviour begins with: a name that is no word of Arcomat's own. */
    String keyword();

    /**
     * The codes of what may be wrong with a text, as those of a guest's laws, each with a page:
     * beside {@code ARC1203}, which stands for whatever has no code.
     */
    default List<String> codes() {
        return List.of();
    }

    /**
     * Words of the language, its keyword perhaps among them, each with a sentence on what it says.
     * Editors colour them, show the sentence beside them, and offer them where a text is written.
     */
    default Map<String, String> words() {
        return Map.of();
    }

    /**
     * What could be written at a place of a text, which need not be finished there: the words of
     * the language if nothing else is said.
     *
     * @param offset of the place in the text of the body, behind what stands of a word already
     */
    default List<Suggestion> suggestions(Written behaviour, int offset) {
        return words().entrySet().stream()
                .filter(each -> !each.getKey().equals(keyword()))
                .map(each -> new Suggestion(each.getKey(), each.getValue()))
                .toList();
    }

    /**
     * Something that could be written.
     *
     * @param text in the place of the word that is being written
     * @param what it is, in a few words
     */
    record Suggestion(String text, String what) {}

    /**
     * The text of a body in canonical form, for {@code arcomat format} and editors; nothing if it
     * is to stay as it was written, as where it cannot be read. White space is all that may differ.
     * One line stays beside the braces; several get lines of their own, and are moved right as far
     * as the behaviour stands. {@link Indentation} is enough for most languages with blocks.
     */
    default Optional<String> layout(Written behaviour) {
        return Optional.empty();
    }

    /**
     * Says what a behaviour means.
     *
     * @param meaning takes it, and what is wrong with the text
     */
    void translate(Written behaviour, Meaning meaning);

    /**
     * A behaviour as somebody wrote it.
     *
     * @param keyword the word that it begins with
     * @param name behind the word, if there is one
     * @param body the text between the braces; comments are in it
     * @param gaps parts of the body that are wrong, which has been told: see {@link Meaning#gap}
     */
    record Written(Span keyword, Optional<Name> name, Span body, List<Span> gaps) {
        public Written {
            gaps = List.copyOf(gaps);
        }

        /** One of which all can be read, as far as is known. */
        public Written(Span keyword, Optional<Name> name, Span body) {
            this(keyword, name, body, List.of());
        }

        /**
         * The text between the braces, with blanks in the place of what is wrong, so that all else
         * stands where it stood.
         */
        public String text() {
            StringBuilder text = new StringBuilder(body.text());
            for (Span gap : gaps) {
                for (int i = gap.start() - body.start(); i < gap.end() - body.start(); i++) {
                    if (text.charAt(i) != '\n') {
                        text.setCharAt(i, ' ');
                    }
                }
            }
            return text.toString();
        }

        /** From the word to the brace that ends it. */
        public Span whole() {
            return new Span(body.file(), keyword.start(), body.end() + 1);
        }

        /** A part of the body, by offsets in its text. */
        public Span part(int start, int end) {
            return new Span(body.file(), body.start() + start, body.start() + end);
        }
    }
}
