package arcomat.editor.answer.completion;

import arcomat.source.SourceFile;
import arcomat.syntax.Continuations;

import java.util.Collection;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;

/**
 * What could be written at a place of a model, whoever asks: a server of editors or a page.
 *
 * @param names that fit
 * @param words of the language, none of them one of the names
 * @param pieces to be filled in, none called like a name or a word
 * @param isBehaviour whether the behaviour of a component may begin there
 */
public record Offers(
        List<Proposal> names, List<String> words, List<Skeleton> pieces, boolean isBehaviour) {
    /** What the grammar takes for the sake of old models, and nobody should begin with. */
    private static final Set<String> OUTDATED =
            Set.of(
                    "boolean", "byte", "call", "char", "double", "float", "int", "long", "new",
                    "null", "short");

    /** A word that behaviours begin with, and only behaviours of components. */
    private static final String BEHAVIOUR = "table";

    /**
     * @param file with the statement that is being written
     * @param place in it
     */
    public static Offers at(SourceFile file, WritingPlace place) {
        Continuations possible = Continuations.at(place.caret(), file);
        KnownNames known = new KnownNames(place);
        Map<String, Proposal> names = new LinkedHashMap<>();
        possible.names().stream()
                .flatMap(rules -> known.at(rules).stream())
                .forEach(name -> names.putIfAbsent(name.label(), name));
        Collection<String> taken = names.keySet();
        List<String> words =
                possible.words().stream()
                        .filter(word -> !OUTDATED.contains(word) && !taken.contains(word))
                        .toList();
        List<Skeleton> pieces =
                Skeleton.ALL.stream()
                        .filter(piece -> piece.fits(possible))
                        .filter(piece -> !taken.contains(piece.label()))
                        .toList();
        return new Offers(
                List.copyOf(names.values()), words, pieces, possible.words().contains(BEHAVIOUR));
    }
}
