package arcomat.translate;

import arcomat.guest.BehaviourLanguage.Written;
import arcomat.guest.Meaning;
import arcomat.guest.Meaning.Piece;
import arcomat.source.SourceFile;
import arcomat.source.Span;
import arcomat.symbols.signatures.BehaviourReader.Problem;
import arcomat.symbols.signatures.BehaviourReader.Reading;
import arcomat.syntax.Parser.Translated;
import arcomat.tree.Automaton;
import arcomat.tree.Behaviour;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.function.UnaryOperator;

/**
 * What a language has said of a behaviour.
 *
 * @param text what it means, as an automaton that nobody has read yet
 */
public record LanguageTranslation(
        Behaviour.Foreign behaviour, Meaning meaning, TranslatedText text) {
    /** Reads a text that was made of another one; nothing where it has errors. */
    public interface Parsing {
        Optional<Translated> parse(SourceFile text, UnaryOperator<Span> places);
    }

    /** A behaviour as its language sees it. */
    public static Written written(Behaviour.Foreign behaviour) {
        return new Written(
                behaviour.keyword().span(), behaviour.name(), behaviour.body(), behaviour.gaps());
    }

    public static LanguageTranslation of(Behaviour.Foreign behaviour, Meaning meaning) {
        Span keyword = behaviour.keyword().span();
        List<Piece> pieces = new ArrayList<>();
        pieces.add(own(keyword, "automaton {"));
        Optional<Span> element = Optional.empty();
        for (Piece each : meaning.pieces()) {
            if (!each.element().equals(element)) {
                pieces.add(own(keyword, "\n")); // errors of one line may be echoes
            }
            element = each.element();
            pieces.add(each);
        }
        pieces.add(own(behaviour.span(), "}"));
        String path = behaviour.span().file().path() + ".ioautomaton";
        return new LanguageTranslation(behaviour, meaning, TranslatedText.of(path, pieces));
    }

    private static Piece own(Span place, String text) {
        return new Piece(place, text, Optional.empty(), 0, 0, List.of());
    }

    /**
     * The automaton, beside what is wrong; nothing where the text cannot be read.
     *
     * @param problems as they are told
     */
    public Optional<Reading> reading(Parsing parsing, List<Problem> problems) {
        return parsing.parse(text.file(), text::origin)
                .map(
                        translated ->
                                new Reading(
                                        Optional.of(automaton(translated)),
                                        problems,
                                        meaning.codes(),
                                        text.takenOver(),
                                        meaning.named()));
    }

    private Automaton automaton(Translated translated) {
        Automaton ordered =
                text.ordered(
                        (Automaton) translated.written().definition(),
                        (Automaton) translated.placed().definition());
        return new Automaton(
                behaviour.span(), behaviour.stereotypes(), behaviour.name(), ordered.elements());
    }
}
