package arcomat.guest;

import arcomat.source.Span;
import arcomat.tree.Name;

import java.util.List;
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
     */
    record Written(Span keyword, Optional<Name> name, Span body) {
        /** A part of the body, by offsets in its text. */
        public Span part(int start, int end) {
            return new Span(body.file(), body.start() + start, body.start() + end);
        }
    }
}
