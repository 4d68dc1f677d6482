package arcomat.guest;

import java.util.List;

/**
 * A language whose texts say different things at different places: it asks which ports, variables
 * and parameters are around, and of which types. It is asked twice, when its text is read, and when
 * names are known. What it finds wrong then is told among the findings of laws, and the rest of the
 * file is looked at as always.
 */
public interface SituatedLanguage extends BehaviourLanguage {
    /**
     * What can be said of the text alone. A problem here is like an error in the syntax, and nobody
     * asks further; something that is written here is the meaning, and nobody asks further either.
     */
    @Override
    default void translate(Written behaviour, Meaning meaning) {}

    /**
     * Says what a behaviour means where it stands. It is asked again for each configuration of a
     * component with features, and keeps nothing in between.
     */
    void translate(Written behaviour, Vicinity around, Meaning meaning);

    /** As {@link #suggestions(Written, int)}, of what can be known while somebody writes. */
    default List<Suggestion> suggestions(Written behaviour, Vicinity around, int offset) {
        return suggestions(behaviour, offset);
    }
}
